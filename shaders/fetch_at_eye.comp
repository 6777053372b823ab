#version 450 core
// Fetch of the triangles that hold the eye, whose hits there are in no tile.

#include "include/views.glsl"
#include "include/deposits.glsl"

layout(local_size_x = 64) in;

layout(binding = 5) uniform usamplerBuffer atEye;

layout(location = 2) uniform uint atEyeCount;

void main() {
    if (gl_GlobalInvocationID.x >= atEyeCount) return;
    uint primitive = texelFetch(atEye, int(gl_GlobalInvocationID.x)).x;
    uint group = findGroup(uint(grid.views), 0u, primitive);
    if (group != kNoRecord) deposit(group, attributesOf(primitive));
}
