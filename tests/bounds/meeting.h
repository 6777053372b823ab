#pragma once

#include "core/trace/intersect.h"
#include "tests/bounds/climb.h"

#include <algorithm>

#include <glm/geometric.hpp>

/// Rays and triangles for hill climbing.
namespace dirt::test {

template <class Vec>
double maxNorm(const Vec& x) {
    return std::max({std::abs((double) x.x), std::abs((double) x.y), std::abs((double) x.z)});
}
template <class Vec>
double oneNorm(const Vec& x) {
    return std::abs((double) x.x) + std::abs((double) x.y) + std::abs((double) x.z);
}

/// Origin, direction, triangle.
using Meeting = Numbers<15>;
inline Ray rayOf(const Meeting& in) {
    return {vectorAt(in, 0), vectorAt(in, 1), kNoPrimitive};
}
inline Triangle triangleOf(const Meeting& in) {
    return {vectorAt(in, 2), vectorAt(in, 3), vectorAt(in, 4)};
}
inline bool isCase(const Meeting& in) {
    for (const float x : in)
        if (!(std::abs(x) < 0x1p20f)) return false;
    return isTraceable(rayOf(in));
}

/// A ray at a triangle of \p size of its distance, from \p height of it above its plane.
inline Meeting meeting(Random& random, double size, double height) {
    const auto point = [&] {
        return glm::dvec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    };
    const glm::dvec3 at = point();
    const glm::dvec3 a = at + size * point(), b = at + size * point(), c = at + size * point();
    const glm::dvec3 normal = glm::cross(b - a, c - a) / (size * size);
    const glm::dvec3 inside = (a + b + c) / 3.0;
    const glm::dvec3 along =
        (b - a) * (random.uniform(-1, 1) / size) + (c - a) * (random.uniform(-1, 1) / size);
    const glm::dvec3 origin = inside + along + normal * height;
    const glm::dvec3 direction = inside - origin;
    Meeting in;
    size_t i = 0;
    for (const glm::dvec3& p : {origin, direction, a, b, c})
        for (int k = 0; k < 3; ++k) in[i++] = (float) p[k];
    return in;
}

} // namespace dirt::test
