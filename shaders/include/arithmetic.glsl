// Directions scaled to fit floats.

#include "shared/rounding.h"

/// v times a power of two that brings its largest |component| into [0.5, 1), without denormals.
/// The components are 0 or normal, and so is the scale.
vec3 scaledToUnit(dvec3 v) {
    double largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
    if (largest == 0.0LF) return vec3(0.0);
    uint exponent = (unpackDouble2x32(largest).y >> 20) & 0x7ffu; // 2^(exponent - 1022) > largest
    double scale = packDouble2x32(uvec2(0u, (2045u - exponent) << 20));
    precise vec3 unit = vec3(v * scale);
    return flushed(unit);
}
