#include "core/verify/exact.h"

#include <cfloat>
#include <cmath>
#include <limits>

namespace dirt {

Dyadic::Dyadic(double value) {
    int exponent = 0;
    const double fraction = std::frexp(value, &exponent);
    mantissa_ = (long long) std::ldexp(fraction, 53);
    exponent_ = exponent - 53;
    if (mantissa_.is_zero()) return;
    // Short mantissas keep the products short.
    const int zeros = (int) lsb(abs(mantissa_));
    mantissa_ >>= zeros;
    exponent_ += zeros;
}

Dyadic operator+(const Dyadic& a, const Dyadic& b) {
    if (a.sign() == 0) return b;
    if (b.sign() == 0) return a;
    if (a.exponent_ >= b.exponent_)
        return {(a.mantissa_ << (a.exponent_ - b.exponent_)) + b.mantissa_, b.exponent_};
    return {a.mantissa_ + (b.mantissa_ << (b.exponent_ - a.exponent_)), a.exponent_};
}

double Dyadic::leading(int& e) const {
    const Integer magnitude = abs(mantissa_);
    const int shift = (int) msb(magnitude) - 52;
    const Integer top = shift > 0 ? Integer(magnitude >> shift) : Integer(magnitude << -shift);
    e = exponent_ + shift;
    return sign() * (double) top.convert_to<long long>();
}

double Dyadic::quotient(const Dyadic& a, const Dyadic& b) {
    if (a.sign() == 0) return 0.0;
    int ea = 0, eb = 0;
    const double ma = a.leading(ea), mb = b.leading(eb);
    return std::ldexp(ma / mb, ea - eb);
}

DyadicVector cross(const DyadicVector& a, const DyadicVector& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

Dyadic dot(const DyadicVector& a, const DyadicVector& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

namespace {

/// A point whose coordinates are v / weight, weight > 0.
struct Homogeneous {
    DyadicVector v;
    Dyadic weight;
};

/// Sign of the area of (a, b, p) in the plane of axes \p i and \p j.
int orientation(const DyadicVector& a, const DyadicVector& b, const Homogeneous& p, int i, int j) {
    const Dyadic pi = p.v[i] - a[i] * p.weight, pj = p.v[j] - a[j] * p.weight;
    return ((b[i] - a[i]) * pj - (b[j] - a[j]) * pi).sign();
}

} // namespace

std::optional<ExactT> intersectExactly(const Ray& ray, const Triangle& triangle) {
    const DyadicVector o(ray.origin), d(ray.direction);
    const DyadicVector a(triangle.a), b(triangle.b), c(triangle.c);
    const DyadicVector normal = cross(b - a, c - a);

    ExactT t{dot(normal, a - o), dot(normal, d)};
    if (t.denominator.sign() == 0) return std::nullopt;
    if (t.denominator.sign() < 0) t = {-t.numerator, -t.denominator};
    if (t.numerator.sign() < 0) return std::nullopt;
    if (t.numerator.sign() == 0 && ray.origin == glm::vec3(0.0f)) return std::nullopt; // the eye

    const Homogeneous p{{o.x * t.denominator + d.x * t.numerator,
                         o.y * t.denominator + d.y * t.numerator,
                         o.z * t.denominator + d.z * t.numerator},
                        t.denominator};
    // Along an axis in which the normal has a part, the projection keeps the triangle's area.
    const int axis = normal.x.sign() != 0 ? 0 : normal.y.sign() != 0 ? 1 : 2;
    const int i = (axis + 1) % 3, j = (axis + 2) % 3;
    const int front = normal[axis].sign();
    if (front * orientation(a, b, p, i, j) < 0 || front * orientation(b, c, p, i, j) < 0 ||
        front * orientation(c, a, p, i, j) < 0)
        return std::nullopt;
    return t;
}

namespace {

// A t is computed with a relative error of 2^-28 (kRelativeErrorT) before it is found to be below
// FLT_MIN, which makes it zero, or above FLT_MAX, which makes it that.
constexpr double kLeast = FLT_MIN * (1.0 + 0x1p-28), kMost = FLT_MAX * (1.0 - 0x1p-28);

/// Whether such a t may be zero.
bool mayVanish(const ExactT& t) {
    return t.numerator < Dyadic(kLeast) * t.denominator;
}
/// Whether such a t may be FLT_MAX.
bool mayBeCut(const ExactT& t) {
    return Dyadic(kMost) * t.denominator < t.numerator;
}

} // namespace

double relativeError(float t, const ExactT& exact) {
    if (!std::isfinite(t)) return std::numeric_limits<double>::infinity();
    const Dyadic difference = Dyadic(t) * exact.denominator - exact.numerator;
    if (difference.sign() == 0) return 0.0;
    if (t == 0.0f && mayVanish(exact)) return 0.0;
    if (t == FLT_MAX && mayBeCut(exact)) return 0.0;
    if (exact.numerator.sign() == 0) return std::numeric_limits<double>::infinity();
    return std::abs(Dyadic::quotient(difference, exact.numerator));
}

double ulpError(float t, const ExactT& exact) {
    // exact = m 2^e with m in [0.5, 1), and an ulp of it is 2^(e - 24).
    int exponent = 0;
    return relativeError(t, exact) * std::frexp(exact.toDouble(), &exponent) * 0x1p24;
}

bool beyondFloats(const ExactT& a, const ExactT& b) {
    return (mayVanish(a) && mayVanish(b)) || (mayBeCut(a) && mayBeCut(b));
}

bool exceeds(const ExactT& t, const ExactT& nearest, float relative) {
    const Dyadic rest = Dyadic(1.0) - Dyadic(relative);
    return nearest.numerator * t.denominator < t.numerator * rest * nearest.denominator;
}

int sideOfBorder(const Ray& ray, const ExactT& t, int axis, float slope, int axisW, float signW) {
    const auto coordinate = [&](int i) {
        return Dyadic(ray.origin[i]) * t.denominator + Dyadic(ray.direction[i]) * t.numerator;
    };
    return (coordinate(axis) - Dyadic(slope) * Dyadic(signW) * coordinate(axisW)).sign();
}

} // namespace dirt
