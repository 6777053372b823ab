// Bilinear lookup between texel centres: which texels, and their weights. Filtering by hardware has
// 8 bits of weight.
#ifndef DIRT_SHARED_TEXTURE_LOOKUP_H
#define DIRT_SHARED_TEXTURE_LOOKUP_H

#include "shaders/shared/language.h"

DIRT_SHARED_BEGIN

/// The two texels between whose centres a coordinate lies, and the second one's weight.
struct TexelPair {
    int first;
    int second;
    float weight;
};

/// Of an image that repeats. \p position: in periods of \p size texels; any finite number.
DIRT_FUNCTION TexelPair texelsAround(float position, int size) {
    // In [0, 1]: 1 where a tiny negative position is rounded up, 0 for all floats from 2^23 on.
    DIRT_PRECISE float fraction = position - floor(position);
    DIRT_PRECISE float texel = fraction * float(size) - 0.5f;
    float lower = floor(texel);
    TexelPair pair;
    pair.first = int(lower); // in [-1, size - 1]
    pair.second = pair.first + 1 < size ? pair.first + 1 : 0;
    if (pair.first < 0) pair.first = size - 1;
    DIRT_PRECISE float weight = texel - lower;
    pair.weight = weight;
    return pair;
}

// What is beyond the image's border: Wrap of core/scene/texture_sampling.h.
const uint kWrapRepeat = 0u;
const uint kWrapMirror = 1u;
const uint kWrapClamp = 2u;

/// Where in an image, along a side from 0 to 1, \p position lies that may be beyond it; \p wrap:
/// kWrapMirror or kWrapClamp. Any finite number.
DIRT_FUNCTION float withinImage(float position, uint wrap) {
    if (wrap == kWrapClamp) return position > 0.0f ? (position < 1.0f ? position : 1.0f) : 0.0f;
    // In [0, 2]: exact but for tiny negative positions; 0 for all floats from 2^24 on.
    DIRT_PRECISE float period = position - 2.0f * floor(position * 0.5f);
    DIRT_PRECISE float back = 2.0f - period;
    return period > 1.0f ? back : period;
}

/// Of an image that ends. \p position: along a side of \p size texels, from 0 to 1.
DIRT_FUNCTION TexelPair texelsWithin(float position, int size) {
    DIRT_PRECISE float texel = position * float(size) - 0.5f;
    float lower = floor(texel);
    int first = int(lower); // in [-1, size - 1]
    TexelPair pair;
    pair.first = first < 0 ? 0 : first;
    pair.second = first + 1 < size ? first + 1 : size - 1;
    DIRT_PRECISE float weight = texel - lower;
    pair.weight = weight;
    return pair;
}

/// The columns around \p u, which runs to the right.
DIRT_FUNCTION TexelPair columnsAround(float u, int width, uint wrap) {
    if (wrap == kWrapRepeat) return texelsAround(u, width);
    return texelsWithin(withinImage(u, wrap), width);
}

/// The rows, which run downwards, around \p v, which runs upwards.
DIRT_FUNCTION TexelPair rowsAround(float v, int height, uint wrap) {
    if (wrap == kWrapRepeat) return texelsAround(-v, height);
    DIRT_PRECISE float fromTop = 1.0f - withinImage(v, wrap);
    return texelsWithin(fromTop, height);
}

/// \p x within what any wrap can tell apart, finite even where \p x isn't: from 2^24 on all floats
/// are even.
DIRT_FUNCTION float boundedTexcoord(float x) {
    return x > -16777216.0f ? (x < 16777216.0f ? x : 16777216.0f) : -16777216.0f;
}

/// \p rowU and \p rowV, of TextureSampling, times \p uv: a difference of texture coordinates.
DIRT_FUNCTION vec2 transformDifference(vec2 uv, vec3 rowU, vec3 rowV) {
    DIRT_PRECISE float u = rowU.x * uv.x + rowU.y * uv.y;
    DIRT_PRECISE float v = rowV.x * uv.x + rowV.y * uv.y;
    return vec2(u, v);
}

/// The same of texture coordinates.
DIRT_FUNCTION vec2 transformTexcoord(vec2 uv, vec3 rowU, vec3 rowV) {
    DIRT_PRECISE float u = rowU.x * uv.x + rowU.y * uv.y + rowU.z;
    DIRT_PRECISE float v = rowV.x * uv.x + rowV.y * uv.y + rowV.z;
    return vec2(boundedTexcoord(u), boundedTexcoord(v));
}

/// \p a by 1 - \p weight and \p b by \p weight.
DIRT_FUNCTION float blend(float a, float b, float weight) {
    DIRT_PRECISE float value = (1.0f - weight) * a + weight * b;
    return value;
}

/// \p a by 1 - \p weight and \p b by \p weight.
DIRT_FUNCTION vec3 blend(vec3 a, vec3 b, float weight) {
    DIRT_PRECISE vec3 value = (1.0f - weight) * a + weight * b;
    return value;
}

DIRT_SHARED_END

#endif
