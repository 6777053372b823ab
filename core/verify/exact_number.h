#pragma once

#include <algorithm>
#include <climits>
#include <cmath>
#include <cstdint>

#include <boost/multiprecision/cpp_int.hpp>
#include <glm/vec3.hpp>

/// Exact arithmetic for judges and oracles. A float is an integer times a power of two, so that a
/// few floats over one common power of two are integers, and no oracle needs a fraction.
namespace dirt {

/// Unbounded; up to 512 bits without an allocation.
using Integer = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<512>,
                                              boost::multiprecision::et_off>;

/// Exponent of the lowest set bit of \p value; INT_MAX for zero.
inline int lowestExponent(double value) {
    if (value == 0.0) return INT_MAX;
    int exponent;
    const int64_t mantissa = (int64_t) std::ldexp(std::frexp(value, &exponent), 53);
    return exponent - 53 + __builtin_ctzll((uint64_t) mantissa);
}

inline int lowestExponent(glm::vec3 p) {
    return std::min({lowestExponent(p.x), lowestExponent(p.y), lowestExponent(p.z)});
}

/// \p value / 2^exponent, which has to be an integer.
inline Integer toInteger(double value, int exponent) {
    if (value == 0.0) return 0;
    const int lowest = lowestExponent(value);
    return Integer((int64_t) std::ldexp(value, -lowest)) << (lowest - exponent);
}

inline int sign(const Integer& value) {
    return value.sign();
}

/// The double nearest to \p value * 2^exponent, but for a relative error of 2^-60.
inline double toDouble(const Integer& value, int exponent = 0) {
    if (value == 0) return 0.0;
    const Integer magnitude = abs(value);
    const int shift = std::max(0, (int) msb(magnitude) - 62);
    const double rounded = std::ldexp((double) (uint64_t) (magnitude >> shift), shift + exponent);
    return value < 0 ? -rounded : rounded;
}

/// A vector of integers.
struct IntegerVector {
    Integer x, y, z;

    friend IntegerVector operator+(const IntegerVector& a, const IntegerVector& b) {
        return {a.x + b.x, a.y + b.y, a.z + b.z};
    }
    friend IntegerVector operator-(const IntegerVector& a, const IntegerVector& b) {
        return {a.x - b.x, a.y - b.y, a.z - b.z};
    }
    friend IntegerVector operator*(const IntegerVector& a, const Integer& k) {
        return {a.x * k, a.y * k, a.z * k};
    }
    bool isZero() const { return x == 0 && y == 0 && z == 0; }
};

/// \p p / 2^exponent.
inline IntegerVector toIntegers(glm::vec3 p, int exponent) {
    return {toInteger(p.x, exponent), toInteger(p.y, exponent), toInteger(p.z, exponent)};
}

inline Integer dot(const IntegerVector& a, const IntegerVector& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

inline IntegerVector cross(const IntegerVector& a, const IntegerVector& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// numerator / denominator * 2^exponent, denominator > 0.
struct Fraction {
    Integer numerator = 0, denominator = 1;
    int exponent = 0;

    double value() const {
        if (numerator == 0) return 0.0;
        // 64 bits more than the denominator has, so that the quotient keeps 64 digits.
        const int shift = std::max(0, (int) msb(denominator) + 64 - (int) msb(abs(numerator)));
        return toDouble((numerator << shift) / denominator, exponent - shift);
    }
};

/// Sign of f - fraction.
inline int compare(double f, const Fraction& fraction) {
    const int lowest =
        std::min(f == 0.0 ? fraction.exponent : lowestExponent(f), fraction.exponent);
    return sign(toInteger(f, lowest) * fraction.denominator -
                (fraction.numerator << (fraction.exponent - lowest)));
}

/// Sign of a - b, which must have the same exponent.
inline int compare(const Fraction& a, const Fraction& b) {
    return sign(a.numerator * b.denominator - b.numerator * a.denominator);
}

/// The float next below (or equal to) \p fraction, and the next above (or equal).
inline float floatBelow(const Fraction& fraction) {
    float f = (float) fraction.value();
    while (compare(f, fraction) > 0) f = std::nextafter(f, -INFINITY);
    return f;
}
inline float floatAbove(const Fraction& fraction) {
    float f = (float) fraction.value();
    while (compare(f, fraction) < 0) f = std::nextafter(f, INFINITY);
    return f;
}

} // namespace dirt
