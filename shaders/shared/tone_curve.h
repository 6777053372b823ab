#ifndef DIRT_SHARED_TONE_CURVE_H
#define DIRT_SHARED_TONE_CURVE_H

#include "shaders/shared/exponential.h"

DIRT_SHARED_BEGIN

/// V' = log(1.0001 + gain V) / log(1.0001 + gain white), for V >= 0. \p gain is 10^key;
/// \p scale is the reciprocal of the denominator.
DIRT_FUNCTION float toneCurve(float value, float gain, float scale) {
    DIRT_PRECISE float encoded = naturalLog(1.0001f + gain * value) * scale;
    return encoded;
}

/// Display encoding: the value V of HSV goes through the curve; hue and saturation stay. Black has
/// no hue and becomes the grey of V'(0).
DIRT_FUNCTION vec3 toneMap(vec3 radiance, float gain, float scale) {
    float value = radiance.x > 0.0f ? radiance.x : 0.0f;
    value = radiance.y > value ? radiance.y : value;
    value = radiance.z > value ? radiance.z : value;
    float encoded = toneCurve(value, gain, scale);
    if (value == 0.0f) return vec3(encoded, encoded, encoded);
    DIRT_PRECISE vec3 mapped = radiance / value * encoded;
    return mapped;
}

DIRT_SHARED_END

#endif
