#pragma once

#include <bit>
#include <cfloat>
#include <cstdint>

namespace dirt {

/// The largest float that is not above \p x >= 0; zero in place of a denormal.
inline float roundDown(double x) {
    if (x < (double) FLT_MIN) return 0.0f;
    if (x >= (double) FLT_MAX) return FLT_MAX;
    const float f = (float) x;
    return f > x ? std::bit_cast<float>(std::bit_cast<uint32_t>(f) - 1) : f;
}

/// The smallest float that is not below \p x >= 0, FLT_MAX at most; FLT_MIN in place of a denormal.
inline float roundUp(double x) {
    if (x <= 0.0) return 0.0f;
    if (x <= (double) FLT_MIN) return FLT_MIN;
    if (x >= (double) FLT_MAX) return FLT_MAX;
    const float f = (float) x;
    return f < x ? std::bit_cast<float>(std::bit_cast<uint32_t>(f) + 1) : f;
}

} // namespace dirt
