#version 450 core
// The third part of FillDepth: the grid frame's scale on a piece of the triangle buffer.

#include "include/arithmetic.glsl"

layout(local_size_x = 256) in;
layout(std430, binding = 0) buffer Triangles {
    float coordinates[];
};
layout(location = 0) uniform uint count;
layout(location = 1) uniform float scale; // a power of two

void main() {
    uint at = gl_GlobalInvocationID.x;
    if (at >= count) return;
    precise float scaled = coordinates[at] * scale;
    coordinates[at] = flushed(scaled);
}
