// Counter-based random numbers: the same bits in C++ and GLSL, in any order of evaluation.
#ifndef DIRT_SHARED_RANDOM_H
#define DIRT_SHARED_RANDOM_H

#include "shaders/shared/language.h"

DIRT_SHARED_BEGIN

/// Dimensions of one path event.
const uint kDimensionLensU = 2u; ///< event 0: where the lens is passed
const uint kDimensionLensV = 3u;
const uint kDimensionScatterU = 0u; ///< events from 1: direction of the ray
const uint kDimensionScatterV = 1u;
const uint kDimensionLobe = 2u;     ///< which lobe chooses it
const uint kDimensionFacet = 3u;    ///< a third number for microfacets
const uint kDimensionRoulette = 4u; ///< whether the path goes on

/// The "pixel" of numbers that all pixels share.
const uint kAllPixels = 0xffffffffu;

/// M. Jarzynski and M. Olano, Hash Functions for GPU Rendering, JCGT 9(3), 2020.
DIRT_FUNCTION uvec4 pcg4d(uvec4 v) {
    v = v * 1664525u + 1013904223u;
    v.x += v.y * v.w;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v.w += v.y * v.z;
    v = v ^ (v >> 16u);
    v.x += v.y * v.w;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v.w += v.y * v.z;
    return v;
}

/// A multiple of 2^-24 in [0, 1).
DIRT_FUNCTION float randomUnit(uint pixel, uint sampleIndex, uint event, uint dimension,
                               uint seed) {
    uvec4 hash = pcg4d(uvec4(pixel, sampleIndex, event * 256u + dimension, seed));
    return float(hash.x >> 8u) * 5.9604644775390625e-8f;
}

DIRT_SHARED_END

#endif
