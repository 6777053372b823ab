#pragma once

#include "core/grid/geometry.h"
#include "core/trace/ray.h"

#include <boost/multiprecision/cpp_int.hpp>

#include <optional>

namespace dirt {

/// The number mantissa * 2^exponent: sums, differences and products of floats without rounding.
class Dyadic {
public:
    Dyadic() = default;
    /// \p value must be finite.
    explicit Dyadic(double value);

    int sign() const { return mantissa_.sign(); }
    Dyadic operator-() const { return {-mantissa_, exponent_}; }
    friend Dyadic operator+(const Dyadic& a, const Dyadic& b);
    friend Dyadic operator-(const Dyadic& a, const Dyadic& b) { return a + -b; }
    friend Dyadic operator*(const Dyadic& a, const Dyadic& b) {
        return {a.mantissa_ * b.mantissa_, a.exponent_ + b.exponent_};
    }
    friend bool operator<(const Dyadic& a, const Dyadic& b) { return (a - b).sign() < 0; }
    /// a / b with a relative error below 2^-50; \p b not zero.
    static double quotient(const Dyadic& a, const Dyadic& b);

private:
    // 512 bits in place: products of six floats of like magnitude need no allocation.
    using Integer = boost::multiprecision::number<
        boost::multiprecision::cpp_int_backend<512, 0, boost::multiprecision::signed_magnitude,
                                               boost::multiprecision::unchecked,
                                               std::allocator<boost::multiprecision::limb_type>>,
        boost::multiprecision::et_off>;

    Dyadic(Integer mantissa, int exponent) : mantissa_(std::move(mantissa)), exponent_(exponent) {}
    /// mantissa_ as m * 2^e with m in [2^52, 2^53], truncated.
    double leading(int& e) const;

    Integer mantissa_ = 0;
    int exponent_ = 0;
};

/// A vector of such numbers.
struct DyadicVector {
    Dyadic x, y, z;

    DyadicVector() = default;
    DyadicVector(Dyadic vx, Dyadic vy, Dyadic vz)
        : x(std::move(vx)), y(std::move(vy)), z(std::move(vz)) {}
    explicit DyadicVector(const glm::dvec3& v) : x(v.x), y(v.y), z(v.z) {}
    const Dyadic& operator[](int i) const { return i == 0 ? x : i == 1 ? y : z; }
    friend DyadicVector operator-(const DyadicVector& a, const DyadicVector& b) {
        return {a.x - b.x, a.y - b.y, a.z - b.z};
    }
};
DyadicVector cross(const DyadicVector& a, const DyadicVector& b);
Dyadic dot(const DyadicVector& a, const DyadicVector& b);

/// The parameter of a hit as a fraction; numerator >= 0, denominator > 0.
struct ExactT {
    Dyadic numerator, denominator;

    friend bool operator<(const ExactT& a, const ExactT& b) {
        return a.numerator * b.denominator < b.numerator * a.denominator;
    }
    double toDouble() const { return Dyadic::quotient(numerator, denominator); }
};

/// Where the ray meets the closed triangle, if it does, in exact arithmetic: the plane's equation
/// gives the point, which is then looked for in the triangle's projection onto a coordinate plane.
/// (core/trace decides by the signs of edge determinants: this shares neither formula nor code
/// with it.) A ray parallel to the plane and a triangle without area are no hit; t = 0 is one.
std::optional<ExactT> intersectExactly(const Ray& ray, const Triangle& triangle);

/// (t - exact) / exact, as a magnitude. Zero where a t below FLT_MIN, as computed, has become zero,
/// or one above FLT_MAX that.
double relativeError(float t, const ExactT& exact);

/// The same error in units in the last place of a float that is \p exact.
double ulpError(float t, const ExactT& exact);

/// Whether floats need not tell the two apart, as both may be below FLT_MIN, or above FLT_MAX.
bool beyondFloats(const ExactT& a, const ExactT& b);

/// Whether \p t exceeds \p nearest by more than \p relative * t.
bool exceeds(const ExactT& t, const ExactT& nearest, float relative);

/// Sign of p[axis] - slope * p[axisW] * signW at the point p = origin + t * direction.
int sideOfBorder(const Ray& ray, const ExactT& t, int axis, float slope, int axisW, float signW);

} // namespace dirt
