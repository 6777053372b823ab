// Where float's range of radiance ends.
#ifndef DIRT_SHARED_RADIANCE_H
#define DIRT_SHARED_RADIANCE_H

#include "shaders/shared/language.h"

DIRT_SHARED_BEGIN

/// Irradiance, throughput, and the radiance of a sample, are at most this, 2^96: what is more, or
/// no number, is taken for it. Any 2^31 samples have a finite sum. And between one bound and the
/// next nothing becomes a NaN: a product of a throughput and a radiance may be infinite, but
/// neither factor is, so none is infinity times 0; nor is anything subtracted.
const float kMostRadiance = 7.922816251426434e+28f;

DIRT_FUNCTION float boundedRadiance(float x) {
    return (floatBitsToUint(x) & 0x7fffffffu) < floatBitsToUint(kMostRadiance) ? x : kMostRadiance;
}
DIRT_FUNCTION vec3 boundedRadiance(vec3 x) {
    return vec3(boundedRadiance(x.x), boundedRadiance(x.y), boundedRadiance(x.z));
}

/// Whether a component has reached the bound.
DIRT_FUNCTION bool reachesBound(vec3 x) {
    return x.x >= kMostRadiance || x.y >= kMostRadiance || x.z >= kMostRadiance;
}

DIRT_SHARED_END

#endif
