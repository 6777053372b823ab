// Floats without denormals (G7), and rounding outwards.
#ifndef DIRT_SHARED_ROUNDING_H
#define DIRT_SHARED_ROUNDING_H

#include "shaders/shared/language.h"

DIRT_SHARED_BEGIN

const float kSmallestNormal = 1.17549435e-38f;
const float kLargest = 3.40282347e38f;

/// \p x, or zero where it is denormal; for code that must not depend on the mode (denormals.h).
DIRT_FUNCTION float flushed(float x) {
    return abs(x) < kSmallestNormal ? 0.0f : x;
}
DIRT_FUNCTION vec3 flushed(vec3 v) {
    return vec3(flushed(v.x), flushed(v.y), flushed(v.z));
}

#ifndef DIRT_NO_DOUBLES

/// The largest float that is not above \p x >= 0; zero in place of a denormal.
DIRT_FUNCTION float roundDown(double x) {
    if (x < double(kSmallestNormal)) return 0.0f;
    if (x >= double(kLargest)) return kLargest;
    DIRT_PRECISE float f = float(x);
    return double(f) > x ? uintBitsToFloat(floatBitsToUint(f) - 1u) : f;
}

/// The smallest float that is not below \p x >= 0, the largest at most; the smallest normal one in
/// place of a denormal.
DIRT_FUNCTION float roundUp(double x) {
    if (x <= double(0.0f)) return 0.0f;
    if (x <= double(kSmallestNormal)) return kSmallestNormal;
    if (x >= double(kLargest)) return kLargest;
    DIRT_PRECISE float f = float(x);
    return double(f) < x ? uintBitsToFloat(floatBitsToUint(f) + 1u) : f;
}

#endif

DIRT_SHARED_END

#endif
