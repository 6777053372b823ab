// Bilinear lookup between texel centres, repeating: which texels, and their weights. Filtering by
// hardware has 8 bits of weight.
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

/// \p position: in periods of \p size texels; any finite number.
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
