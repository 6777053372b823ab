#pragma once

#include "core/grid/geometry.h"
#include "core/trace/ray.h"

namespace dirt {

/// err(t) = kRelativeErrorT * t (T4): hits whose computed t are in one order have exact t in the
/// same order, or apart by less. A hit's t is the exact value with a relative error of at most
/// 2^-28, rounded once to float: 2^-24 + 2^-28 each, 2^-23 (1 + 2^-4) for two, here rounded up to
/// 2^-23 (1 + 2^-3). Results below FLT_MIN become zero.
inline constexpr float kRelativeErrorT = 0x1.2p-23f;

/// A ray's intersection with one triangle.
struct TriangleHit {
    float t = 0.0f;
    float u = 0.0f, v = 0.0f; ///< barycentric weights of b and c, absolute error below 2^-22
};

/// Whether the exact ray (t >= 0) meets the closed triangle, decided by exact signs (T4): a ray in
/// the triangle's plane and a triangle without area are no hit. Does not look at ray.skip.
bool intersect(const Ray& ray, const Triangle& triangle, TriangleHit& out);

/// Whether two triangles have exactly the same three vertices, in any order (T5).
bool sameVertices(const Triangle& a, const Triangle& b);

/// Whether all six numbers of the ray are finite and its direction is not zero (T6).
bool isTraceable(const Ray& ray);

} // namespace dirt
