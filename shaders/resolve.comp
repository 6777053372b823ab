#version 450 core
// Resolve: adds the sample's radiance to the image, and counts the pixels in which it was clamped.

#include "include/paths.glsl"
#include "shared/radiance.h"

layout(local_size_x = 64) in;

layout(std430, binding = 6) buffer ClampedBlock {
    uint clamped;
};

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= pixelCount) return;
    for (uint c = 0u; c < 3u; ++c) {
        precise float sum = image[3u * i + c] + radiance[3u * i + c];
        image[3u * i + c] = sum;
    }
    if (reachesBound(vec3(radiance[3u * i], radiance[3u * i + 1u], radiance[3u * i + 2u])))
        atomicAdd(clamped, 1u);
}
