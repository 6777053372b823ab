#version 450 core
// The first part of FillDepth: world positions to the grid frame, before its scale. The results are
// captured into the triangle buffer, nine floats a triangle.

layout(location = 0) in vec3 world;
layout(location = 0) uniform vec3 eye;
layout(location = 1) uniform bool single; // on the camera's axes
layout(location = 2) uniform vec3 right;
layout(location = 3) uniform vec3 down;
layout(location = 4) uniform vec3 forward;

out vec3 corner;

void main() {
    precise vec3 p = world - eye;
    corner = p;
    if (single) {
        precise vec3 turned = vec3((right.x * p.x + right.y * p.y) + right.z * p.z,
                                   (down.x * p.x + down.y * p.y) + down.z * p.z,
                                   (forward.x * p.x + forward.y * p.y) + forward.z * p.z);
        corner = turned;
    }
}
