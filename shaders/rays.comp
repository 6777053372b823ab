#version 450 core
// Rays: from the eye for event 0; else from G[k], in directions that its lobe chooses. One that
// would leave through the surface gets no direction: the path ends.

#include "include/points.glsl"
#include "include/frame.glsl"
#include "include/triangles.glsl"
#include "include/offset.glsl"
#include "include/viewer.glsl"
#include "shared/random.h"

layout(local_size_x = 64) in;

float random(uint pixel, uint dimension) {
    return randomUnit(pixel, frame.sampleIndex, uint(frame.event), dimension, frame.seed);
}

#if DIRT_SCATTERS
Scattering scatterAt(uint i, uint pixel, SurfacePoint point) {
    float u = random(pixel, kDimensionScatterU);
    float v = random(pixel, kDimensionScatterV);
#if DIRT_GLOSS
    if (isGlossy(point))
        return scatter(point, frame.microfacets, towardsViewer(frame.event - 1, i, point),
                       random(pixel, kDimensionLobe), u, v, random(pixel, kDimensionFacet));
#endif
    return scatter(point, u, v);
}

PathRay scatteredRay(uint i, uint pixel) {
    SurfacePoint point = takenFor(frame.rayType, currentPoint(i));
    Scattering next = scatterAt(i, pixel, point);
    if (next.direction == vec3(0.0)) return kNoRay;
    precise vec3 throughput = next.weight;
    if (frame.event > 1) throughput = rays[i].throughput * throughput;
    if (frame.roulette != 0u && uint(frame.event) >= kFirstRouletteEvent) {
        float chance = survivalChance(throughput);
        if (!(random(pixel, kDimensionRoulette) < chance)) return kNoRay;
        throughput = throughput / chance;
    }
    vec3 origin = offsetOrigin(triangleOf(point.primitive), point.u, point.v, next.direction);
    throughput = boundedRadiance(throughput);
    return PathRay(origin, point.primitive, next.direction, next.pdf, throughput, 0.0);
}
#else
PathRay cameraRay(uint pixel) {
    vec3 direction = directionThrough(uvec2(pixel % frame.width, pixel / frame.width));
    vec3 origin = vec3(0.0);
    if (frame.lens != 0u) {
        vec3 pinhole = direction;
        lensRay(frame.plane, pinhole, random(pixel, kDimensionLensU),
                random(pixel, kDimensionLensV), origin, direction);
    }
    return PathRay(origin, kNoPrimitive, direction, 1.0, vec3(1.0), 0.0);
}
#endif

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= pixelCount) return;
#if DIRT_SCATTERS
    if (!isAlive(frame.event, i))
        rays[i] = kNoRay;
    else
        rays[i] = scatteredRay(i, firstPixel + i);
#else
    rays[i] = cameraRay(firstPixel + i);
#endif
}
