#version 450 core
// FillDepth and FillPrimitives: the triangle buffer's corners, as they are.

layout(location = 0) in vec3 corner;
out vec3 position;

void main() {
    position = corner;
}
