#version 450 core
// Empty records for all paths of a frame.

#include "include/paths.glsl"

layout(local_size_x = 64) in;

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= pixelCount) return;
    next[i] = kNoPoint;
#if DIRT_CURRENT
    current[i] = kNoPoint;
#endif
#if DIRT_RAYS
    rays[i] = kNoRay;
    hits[i] = kNoHit;
#endif
}
