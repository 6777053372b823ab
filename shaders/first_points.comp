#version 450 core
// DirectVisibility, after the rasterization: G[1] of each pixel from the primitive that it sees.

#include "include/points.glsl"
#include "include/attributes.glsl"
#include "include/seen_point.glsl"

layout(local_size_x = 64) in;

layout(binding = 4) uniform usampler2D seenPrimitives;

layout(std430, binding = 7) buffer CountBlock {
    uint found;
};

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= pixelCount) return;
    uvec2 pixel = uvec2((firstPixel + i) % frame.width, (firstPixel + i) / frame.width);
    uint id = texelFetch(seenPrimitives, ivec2(pixel), 0).x;
    if (id == kNoPrimitive) {
        clearNext(i);
        return;
    }
    vec3 direction = primaryRay(directionThrough(pixel)).direction;
    TriangleHit hit;
    seenPoint(primaryRay(direction), triangleOf(id), hit);
    setNext(i, surfaceAt(attributesOf(id), id, hit.u, hit.v, direction));
    atomicAdd(found, 1u);
}
