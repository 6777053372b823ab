#ifndef DIRT_SHARED_ERROR_FUNCTION_H
#define DIRT_SHARED_ERROR_FUNCTION_H

#include "shaders/shared/exponential.h"

DIRT_SHARED_BEGIN

/// e^(x^2) erfc(x) for x >= 0, relative error below 6e-7: t P(t) in t = 1 / (1 + 0.4 x), P by
/// interpolation at Chebyshev's nodes.
DIRT_FUNCTION float scaledErrorComplement(float x) {
    DIRT_PRECISE float t = 1.0f / (1.0f + 0.4f * x);
    DIRT_PRECISE float p = 0.05134633928537369f;
    p = p * t - 0.18732550740242004f;
    p = p * t + 0.1764279305934906f;
    p = p * t - 0.011961572803556919f;
    p = p * t + 0.1444813311100006f;
    p = p * t + 0.16774629056453705f;
    p = p * t + 0.20794466137886047f;
    p = p * t + 0.2256646305322647f;
    p = p * t + 0.22567589581012726f;
    return t * p;
}

/// The same for any x of at most 5 where it is negative, times e^(-x^2), which the caller has:
/// erfc(x).
DIRT_FUNCTION float errorComplement(float x, float gaussian) {
    float tail = scaledErrorComplement(x < 0.0f ? -x : x);
    DIRT_PRECISE float positive = tail * gaussian;
    DIRT_PRECISE float negative = 2.0f - positive;
    return x < 0.0f ? negative : positive;
}

DIRT_SHARED_END

#endif
