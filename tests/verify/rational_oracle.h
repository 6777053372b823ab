#pragma once

#include "core/grid/geometry.h"
#include "core/trace/ray.h"

#include <boost/multiprecision/cpp_int.hpp>

#include <array>
#include <optional>
#include <vector>

namespace dirt::test {

using Rational = boost::multiprecision::cpp_rational;
using RationalVec = std::array<Rational, 3>;

inline RationalVec rational(glm::vec3 v) {
    return {Rational(v.x), Rational(v.y), Rational(v.z)};
}

inline RationalVec operator-(const RationalVec& a, const RationalVec& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

inline Rational determinant(const RationalVec& a, const RationalVec& b, const RationalVec& c) {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/// origin + t d = a + u (b - a) + v (c - a), solved by Cramer's rule over the rationals.
inline std::optional<Rational> rationalHit(const Ray& ray, const Triangle& triangle) {
    const RationalVec o = rational(ray.origin), d = rational(ray.direction);
    const RationalVec a = rational(triangle.a);
    const RationalVec e1 = rational(triangle.b) - a, e2 = rational(triangle.c) - a;
    const RationalVec back{-d[0], -d[1], -d[2]};
    const Rational whole = determinant(back, e1, e2);
    if (whole == 0) return std::nullopt;
    const Rational t = determinant(o - a, e1, e2) / whole;
    const Rational u = determinant(back, o - a, e2) / whole;
    const Rational v = determinant(back, e1, o - a) / whole;
    if (t < 0 || u < 0 || v < 0 || u + v > 1) return std::nullopt;
    return t;
}

/// Every primitive at the nearest t, in increasing order. Does not look at Ray::skip.
inline std::vector<uint32_t> rationalNearest(const FrameGeometry& geometry, const Ray& ray) {
    std::vector<uint32_t> nearest;
    std::optional<Rational> best;
    for (uint32_t id = 0; id < geometry.triangles.size(); id++) {
        const auto t = rationalHit(ray, geometry.triangles[id]);
        if (!t || (best && *t > *best)) continue;
        if (!best || *t < *best) nearest.clear();
        best = t;
        nearest.push_back(id);
    }
    return nearest;
}

} // namespace dirt::test
