#include "core/trace/intersect.h"

#include "core/base/denormals.h"
#include "core/trace/determinant.h"
#include "core/trace/norms.h"
#include "shaders/shared/hit_rules.h"

#include <algorithm>
#include <cfloat>
#include <cmath>

#include <glm/geometric.hpp>

// Bound of a computed determinant d . (B × C) with B = b - o, C = c - o rounded to u = 2^-53.
// Each difference has a relative error u, each product of two of them 3 u, their difference 4 u of
// the magnitudes, times d 5 u, and two sums make it 7 u (1 + O(u)) of
//     sum |d_i| (|B_j C_k| + |B_k C_j|) <= 2 |d|_1 |B|_max |C|_max.
// So the error is below 14 u |d|_1 |B|_max |C|_max and terms of u^2; the code takes 16. Of three
// differences (determinant.cpp) it is one more of these seven; but there only signs in doubt
// matter, where the last sum is exact. Products of three floats cannot underflow.

namespace dirt {
namespace {

/// Of the grid frame. What a plane through it holds is no hit of the rays that start there.
constexpr glm::vec3 kEye(0.0f);

EdgePlanes::Weights exactWeights(glm::vec3 origin, glm::vec3 direction, const Triangle& t) {
    return {edgeDeterminantExact(origin, direction, t.b, t.c),
            edgeDeterminantExact(origin, direction, t.c, t.a),
            edgeDeterminantExact(origin, direction, t.a, t.b), 0.0};
}

/// Repeated vertices are common in real files, tens of thousands in one place, and would be decided
/// by the exact determinants each time.
bool hasRepeatedVertices(const Triangle& t) {
    return t.a == t.b || t.b == t.c || t.c == t.a;
}

/// intersect() without the test above; \p plane() is asked for only where the line meets the
/// triangle.
template <class Plane>
bool meet(glm::vec3 origin, glm::vec3 direction, const Triangle& triangle, const EdgePlanes& edges,
          const Plane& plane, TriangleHit& out) {
    EdgePlanes::Weights weights = edges.along(direction);
    const bool positive = weights.a > 0.0 || weights.b > 0.0 || weights.c > 0.0;
    const bool negative = weights.a < 0.0 || weights.b < 0.0 || weights.c < 0.0;
    // Mixed: the line passes beside the triangle. All zero: it lies in its plane, or there is no
    // area; otherwise their sum, d . normal, is not zero and the line meets the plane in a point.
    if (positive == negative) return false;

    const PlaneDistance& from = plane();
    if (from.side() == 0 && origin == kEye) return false;
    if (!from.at(direction, out.t)) return false;

    // Weights of a tiny far triangle: 2^-24 of their sum has to be above two of their errors.
    if (std::abs(weights.a + weights.b + weights.c) < kSureWeights * weights.bound)
        weights = exactWeights(origin, direction, triangle);
    const double sum = weights.a + weights.b + weights.c;
    out.u = (float) (weights.b / sum);
    out.v = (float) (weights.c / sum);
    return true;
}

} // namespace

PlaneDistance::PlaneDistance(glm::vec3 origin, const Triangle& t) : triangle_(t) {
    const glm::dvec3 a(t.a);
    const glm::dvec3 ab = glm::dvec3(t.b) - a, ac = glm::dvec3(t.c) - a;
    const glm::dvec3 toA = a - glm::dvec3(origin);
    normal_ = glm::cross(ab, ac);
    numerator_ = glm::dot(normal_, toA);
    // The bound above is 2^-49 of the norms; 2^-29 of the value is wanted, here and below.
    norms_ = kPlaneDoubt * maxNorm(ab) * maxNorm(ac);
    if (std::abs(numerator_) <= norms_ * oneNorm(toA))
        numerator_ = -planeDeterminantExact(origin, t.a, t.b, t.c);
}

bool PlaneDistance::at(glm::vec3 direction, float& t) const {
    const glm::dvec3 d(direction);
    double denominator = glm::dot(normal_, d);
    if (std::abs(denominator) <= norms_ * oneNorm(d))
        denominator = directionDeterminantExact(direction, triangle_.a, triangle_.b, triangle_.c);
    if (numerator_ != 0.0 && (numerator_ < 0.0) != (denominator < 0.0)) return false;
    const double exact = std::abs(numerator_ / denominator);
    t = exact < (double) FLT_MIN ? 0.0f : (float) std::min(exact, (double) FLT_MAX);
    return true;
}

EdgePlanes::EdgePlanes(glm::vec3 origin, const Triangle& triangle)
    : origin_(origin), triangle_(triangle) {
    const glm::dvec3 o(origin);
    const glm::dvec3 a = glm::dvec3(triangle.a) - o;
    const glm::dvec3 b = glm::dvec3(triangle.b) - o;
    const glm::dvec3 c = glm::dvec3(triangle.c) - o;
    a_ = glm::cross(b, c), b_ = glm::cross(c, a), c_ = glm::cross(a, b);
    normA_ = maxNorm(a), normB_ = maxNorm(b), normC_ = maxNorm(c);
    largest_ = std::max({normB_ * normC_, normC_ * normA_, normA_ * normB_});
}

EdgePlanes::Weights EdgePlanes::along(glm::vec3 direction) const {
    const glm::dvec3 d(direction);
    const double scale = kEdgeError * oneNorm(d);
    Weights weights{glm::dot(d, a_), glm::dot(d, b_), glm::dot(d, c_), scale * largest_};
    const auto decide = [&](double& weight, double bound, const glm::vec3& from,
                            const glm::vec3& to) {
        if (std::abs(weight) <= bound) weight = edgeDeterminantExact(origin_, direction, from, to);
    };
    decide(weights.a, scale * normB_ * normC_, triangle_.b, triangle_.c);
    decide(weights.b, scale * normC_ * normA_, triangle_.c, triangle_.a);
    decide(weights.c, scale * normA_ * normB_, triangle_.a, triangle_.b);
    return weights;
}

bool intersect(const Ray& ray, const Triangle& triangle, TriangleHit& out) {
    if (hasRepeatedVertices(triangle)) return false;
    const auto plane = [&] { return PlaneDistance(ray.origin, triangle); };
    return meet(ray.origin, ray.direction, triangle, EdgePlanes(ray.origin, triangle), plane, out);
}

TriangleFrom::TriangleFrom(glm::vec3 origin, const Triangle& triangle)
    : triangle_(triangle), origin_(origin), edges_(origin, triangle), plane_(origin, triangle) {}

bool TriangleFrom::intersect(glm::vec3 direction, TriangleHit& out) const {
    if (hasRepeatedVertices(triangle_)) return false;
    const auto plane = [&]() -> const PlaneDistance& { return plane_; };
    return meet(origin_, direction, triangle_, edges_, plane, out);
}

bool sameVertices(const Triangle& a, const Triangle& b) {
    const glm::vec3 x[3] = {a.a, a.b, a.c};
    const glm::vec3 y[3] = {b.a, b.b, b.c};
    static constexpr int kOrders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1},
                                          {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
    for (const auto& order : kOrders)
        if (x[0] == y[order[0]] && x[1] == y[order[1]] && x[2] == y[order[2]]) return true;
    return false;
}

bool isTraceable(const Ray& ray) {
    return isTraceable(ray.origin, ray.direction);
}

Ray flushedRay(const Ray& ray) {
    return {flushed(ray.origin), flushed(ray.direction), ray.skip};
}

} // namespace dirt
