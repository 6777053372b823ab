// How a surface point reflects.
#ifndef DIRT_SHARED_REFLECTION_H
#define DIRT_SHARED_REFLECTION_H

#include "shaders/shared/layouts.h"
#include "shaders/shared/sampling.h"
#include "shaders/shared/spotlight.h"

DIRT_SHARED_BEGIN

DIRT_FUNCTION bool black(vec3 color) {
    return !(color.x > 0.0f || color.y > 0.0f || color.z > 0.0f);
}

/// Cosine for light that arrives from \p direction, zero unless it does so in front of the
/// geometric and the shading normal alike: what an interpolated normal lets in from behind would
/// be a leak.
DIRT_FUNCTION float shadingCosine(SurfacePoint point, vec3 direction) {
    float cosine = dotProduct(point.shadingNormal, direction);
    return dotProduct(point.geometricNormal, direction) > 0.0f && cosine > 0.0f ? cosine : 0.0f;
}

/// Radiance that \p point reflects of an unoccluded light.
DIRT_FUNCTION vec3 reflectedRadiance(SurfacePoint point, LightSample light) {
    float cosine = shadingCosine(point, light.direction);
    DIRT_PRECISE vec3 radiance = point.diffuse * kOneOverPi * light.irradiance * cosine;
    return radiance;
}

/// How a path goes on from a surface without gloss, as Lambert has it. \p u, \p v: in [0, 1).
DIRT_FUNCTION Scattering scatter(SurfacePoint point, float u, float v) {
    Scattering result;
    result.direction = cosineAround(point.shadingNormal, u, v);
    float cosine = shadingCosine(point, result.direction);
    DIRT_PRECISE float pdf = cosine * kOneOverPi;
    result.pdf = pdf;
    result.weight = point.diffuse; // Lambert: the cosine and 1/pi cancel against the density
    if (!(cosine > 0.0f)) result.direction = vec3(0.0f);
    return result;
}

/// SurfacePoint::gloss: reflectance and metallic, of [0, 1], as multiples of 1/65535.
DIRT_FUNCTION uint packGloss(float reflectance, float metallic) {
    DIRT_PRECISE float low = reflectance * 65535.0f + 0.5f;
    DIRT_PRECISE float high = metallic * 65535.0f + 0.5f;
    return uint(low) | uint(high) << 16u;
}

/// Whether the surface has microfacets.
DIRT_FUNCTION bool isGlossy(uint gloss) {
    return (gloss & 0xffffu) != 0u;
}
DIRT_FUNCTION bool isGlossy(SurfacePoint point) {
    return isGlossy(point.gloss);
}

/// What indirect rays take every surface for; the values of RayType.
const uint kRaysDiffuse = 1u;
const uint kRaysGlossy = 2u;
const uint kRaysSpecular = 3u;
const uint kRaysVisibility = 4u;

DIRT_FUNCTION SurfacePoint takenFor(uint rayType, SurfacePoint point) {
    if (rayType == 0u) return point;
    SurfacePoint other = point;
    other.gloss = 0u;
    if (rayType == kRaysVisibility) other.diffuse = vec3(1.0f);
    if (rayType == kRaysGlossy || rayType == kRaysSpecular) {
        other.gloss = packGloss(1.0f, 1.0f);
        other.roughness = rayType == kRaysGlossy ? 0.1f : 0.0f;
    }
    return other;
}

/// Path events from this one on go on by roulette.
const uint kFirstRouletteEvent = 3u;

/// The chance of a path with \p throughput to go on; what it finds is divided by it.
DIRT_FUNCTION float survivalChance(vec3 throughput) {
    float largest = throughput.x > throughput.y ? throughput.x : throughput.y;
    if (throughput.z > largest) largest = throughput.z;
    return largest < 1.0f ? largest : 1.0f;
}

DIRT_SHARED_END

#endif
