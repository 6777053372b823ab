// From depth to bin, for construction and traversal (G3): monotone, and clamped at both ends.
#ifndef DIRT_SHARED_BINS_H
#define DIRT_SHARED_BINS_H

#include "shaders/shared/rounding.h"

DIRT_SHARED_BEGIN

#ifndef DIRT_NO_DOUBLES

/// Bins per depth of a tile with the given bounds; 0, as in a tile without depth: all in the first.
DIRT_FUNCTION float binsPerDepth(float near, float far, int bins) {
    DIRT_PRECISE float depth = far - near;
    depth = flushed(depth);
    if (!(depth > 0.0f)) return 0.0f;
    // A quotient of doubles rounded to float is the correctly rounded quotient of floats, which
    // float division is not everywhere.
    DIRT_PRECISE double quotient = double(bins) / double(depth);
    return quotient <= double(kLargest) ? float(quotient) : 0.0f;
}

#endif

/// The bin of depth \p w, given binsPerDepth.
DIRT_FUNCTION int binOf(float w, float near, float perDepth, int bins) {
    DIRT_PRECISE float offset = w - near;
    DIRT_PRECISE float bin = flushed(offset) * perDepth;
    float last = float(bins - 1);
    return int(bin > 0.0f ? (bin < last ? bin : last) : 0.0f);
}

DIRT_SHARED_END

#endif
