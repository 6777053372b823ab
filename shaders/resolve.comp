#version 450 core
// Resolve: adds the sample's radiance to the image.

#include "include/paths.glsl"

layout(local_size_x = 64) in;

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= pixelCount) return;
    for (uint c = 0u; c < 3u; ++c) {
        precise float sum = image[3u * i + c] + radiance[3u * i + c];
        image[3u * i + c] = sum;
    }
}
