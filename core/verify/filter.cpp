#include "core/verify/filter.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dirt {

namespace {

// Relative to the largest |coordinate| of each of its three vectors, what rounding can do to a
// determinant. With u = 2^-53: a difference of two floats has a relative error of at most u (and
// cannot underflow). A determinant is six products; each carries at most three differences, two
// multiplications and three additions, together (1 + u)^8 - 1 < 8.1 u, and each is at most the
// product of the three largest coordinates: 6 * 8.1 u < 49 u. 64 u leaves room for the rounding
// of the bound itself (three multiplications and the constant's product: below 4 u relative) and
// for the two additions of a sum of three determinants (2 u of at most 6 products each, 12 u).
constexpr double kDeterminantError = 64.0 * 0x1p-53;

struct Vec {
    double x, y, z;
    double largest() const { return std::max({std::abs(x), std::abs(y), std::abs(z)}); }
};

Vec difference(glm::vec3 a, glm::vec3 b) {
    return {(double) a.x - b.x, (double) a.y - b.y, (double) a.z - b.z};
}

/// a . (b x c)
double determinant(const Vec& a, const Vec& b, const Vec& c) {
    return a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) +
           a.z * (b.x * c.y - b.y * c.x);
}

} // namespace

FilterResult filterTriangle(const Ray& ray, const Triangle& triangle) {
    const Vec a = difference(triangle.a, ray.origin);
    const Vec b = difference(triangle.b, ray.origin);
    const Vec c = difference(triangle.c, ray.origin);
    const Vec d{ray.direction.x, ray.direction.y, ray.direction.z};
    const double ma = a.largest(), mb = b.largest(), mc = c.largest();
    const double md = kDeterminantError * d.largest();

    // If the line meets the triangle, the three edges pass it on the same side (or touch it).
    const double ab = determinant(d, a, b), bc = determinant(d, b, c), ca = determinant(d, c, a);
    const double errorAb = md * ma * mb, errorBc = md * mb * mc, errorCa = md * mc * ma;
    const bool left = ab > errorAb || bc > errorBc || ca > errorCa;
    const bool right = ab < -errorAb || bc < -errorBc || ca < -errorCa;
    if (left && right) return {};

    // t = numerator / denominator.
    FilterResult result{true, 0.0, std::numeric_limits<double>::infinity()};
    double denominator = ab + bc + ca;
    const double errorDenominator = errorAb + errorBc + errorCa;
    if (std::abs(denominator) <= errorDenominator) return result;
    double numerator = determinant(a, b, c);
    const double errorNumerator = kDeterminantError * ma * mb * mc;
    if (denominator < 0.0) denominator = -denominator, numerator = -numerator;
    if (numerator < -errorNumerator) return {};
    // Four roundings of u each, widened by 8 u.
    constexpr double kDown = 1.0 - 0x1p-50, kUp = 1.0 + 0x1p-50;
    result.tLow = std::max(0.0, (numerator - errorNumerator) / (denominator + errorDenominator));
    result.tLow *= kDown;
    result.tHigh = (numerator + errorNumerator) / (denominator - errorDenominator) * kUp;
    return result;
}

} // namespace dirt
