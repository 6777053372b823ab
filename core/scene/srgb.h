#pragma once

#include <cmath>

namespace dirt {

/// The linear value of an sRGB-encoded one (IEC 61966-2-1); both in [0, 1].
inline double decodeSrgb(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

} // namespace dirt
