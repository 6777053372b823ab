#include "core/verify/aim.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dirt {

namespace {

constexpr double kFloatIntegers = 1 << 24; ///< integers up to here are floats

/// The value of \p x's lowest set bit; infinity for zero.
double quantum(double x) {
    if (x == 0.0) return std::numeric_limits<double>::infinity();
    int exponent = 0;
    const auto mantissa = (long long) std::ldexp(std::frexp(std::abs(x), &exponent), 53);
    return std::ldexp((double) (mantissa & -mantissa), exponent - 53);
}

/// The multiple of \p q nearest to \p o that lies between \p o and \p m, within [lo, hi] and the
/// integers q * +-2^24. \p m should lie in that interval; it need not be a multiple of q.
double snap(double o, double m, double q, double lo, double hi) {
    lo = std::max(lo, -kFloatIntegers * q), hi = std::min(hi, kFloatIntegers * q);
    const double steps = std::clamp(o, lo, hi) / q;
    return (o > m ? std::floor(steps) : std::ceil(steps)) * q;
}

std::optional<Ray> exactRay(glm::vec3 origin, glm::vec3 direction) {
    if (direction.x == 0.0f && direction.y == 0.0f && direction.z == 0.0f) return std::nullopt;
    return Ray{origin, direction, kNoPrimitive};
}

} // namespace

std::optional<Ray> aimAtPoint(glm::vec3 origin, glm::vec3 target) {
    glm::vec3 direction(0.0f);
    for (int i = 0; i < 3; i++) {
        const double v = target[i], q = quantum(v);
        if (v != 0.0) {
            const double reach = kFloatIntegers * q;
            origin[i] = (float) snap(origin[i], v, q, v - reach, v + reach);
        }
        direction[i] = target[i] - origin[i]; // exact: at most 2^24 steps of q
    }
    return exactRay(origin, direction);
}

std::optional<Ray> aimAtEdge(glm::vec3 origin, glm::vec3 a, glm::vec3 b, int weightA, int weightB) {
    const double sum = weightA + weightB;
    glm::vec3 direction(0.0f);
    for (int i = 0; i < 3; i++) {
        const double q = std::min(quantum(a[i]), quantum(b[i]));
        if (std::isinf(q)) { // both zero
            direction[i] = (float) -sum * origin[i];
            if ((double) direction[i] != -sum * origin[i]) return std::nullopt;
            continue;
        }
        // Sums of the weighted coordinates are exact in double.
        if (std::max(std::abs(a[i]), std::abs(b[i])) > q * 0x1p40) return std::nullopt;
        const double crossing = ((double) weightA * a[i] + (double) weightB * b[i]) / sum;
        const double reach = kFloatIntegers * q / sum;
        const double o = snap(origin[i], crossing, q, crossing - reach, crossing + reach);
        const double d = (double) weightA * (a[i] - o) + (double) weightB * (b[i] - o);
        origin[i] = (float) o, direction[i] = (float) d;
        if ((double) origin[i] != o || (double) direction[i] != d) return std::nullopt;
    }
    return exactRay(origin, direction);
}

} // namespace dirt
