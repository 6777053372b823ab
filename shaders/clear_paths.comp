#version 450 core
// Empty records for all paths of a frame.

#include "include/points.glsl"

layout(local_size_x = 64) in;

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= pixelCount) return;
    clearNext(i);
#if DIRT_CURRENT
    clearCurrent(i);
#endif
#if DIRT_RAYS
    rays[i] = kNoRay;
    hits[i] = kNoHit;
#endif
}
