#version 450 core
// The last part of Visibility: what the search has found occludes.

#include "include/paths.glsl"

layout(local_size_x = 64) in;

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= pixelCount) return;
    if (hits[i].primitive != kNoPrimitive) imageStore(visibility, int(firstPixel + i), uvec4(0u));
}
