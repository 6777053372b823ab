#version 450 core
// DepthMask: the pixels whose path goes on to the event: those that have reached a surface, G[k],
// that reflects.

#include "include/points.glsl"
#include "include/frame.glsl"
#include "shared/reflection.h"

layout(local_size_x = 64) in;

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= pixelCount) return;
    bool reflects = !black(currentDiffuse(i)) || isGlossy(currentGloss(i)) ||
                    frame.rayType == kRaysVisibility;
    bool alive = (frame.event == 1 || isAlive(frame.event, i)) &&
                 foundCurrent(i) && reflects;
    imageStore(mask, int(firstPixel + i), uvec4(alive ? 1u : 0u));
}
