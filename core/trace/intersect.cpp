#include "core/trace/intersect.h"

#include "core/trace/determinant.h"

#include <algorithm>
#include <cfloat>
#include <cmath>

#include <glm/geometric.hpp>

// Bound of a computed determinant d . (B × C) with B = b - o, C = c - o rounded to u = 2^-53.
// Each difference has a relative error u, each product of two of them 3 u, their difference 4 u of
// the magnitudes, times d 5 u, and two sums make it 7 u (1 + O(u)) of
//     sum |d_i| (|B_j C_k| + |B_k C_j|) <= 2 |d|_1 |B|_max |C|_max.
// So the error is below 16 u |d|_1 |B|_max |C|_max. Products of three floats cannot underflow.

namespace dirt {
namespace {

template <class Vec>
auto maxNorm(const Vec& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}
template <class Vec>
auto oneNorm(const Vec& v) {
    return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
}

/// Weights of a, b and c: the edge determinants, with exact signs.
struct EdgeWeights {
    double a, b, c;
    double bound; ///< of each one's absolute error
};

EdgeWeights edgeWeights(const Ray& ray, const Triangle& triangle) {
    const glm::dvec3 o(ray.origin), d(ray.direction);
    const glm::dvec3 a = glm::dvec3(triangle.a) - o;
    const glm::dvec3 b = glm::dvec3(triangle.b) - o;
    const glm::dvec3 c = glm::dvec3(triangle.c) - o;
    const double scale = 0x1p-49 * oneNorm(d);
    const double na = maxNorm(a), nb = maxNorm(b), nc = maxNorm(c);
    EdgeWeights weights{glm::dot(d, glm::cross(b, c)), glm::dot(d, glm::cross(c, a)),
                        glm::dot(d, glm::cross(a, b)),
                        scale * std::max({nb * nc, nc * na, na * nb})};
    const auto decide = [&](double& weight, double bound, const glm::vec3& from,
                            const glm::vec3& to) {
        if (std::abs(weight) <= bound)
            weight = edgeDeterminantExact(ray.origin, ray.direction, from, to);
    };
    decide(weights.a, scale * nb * nc, triangle.b, triangle.c);
    decide(weights.b, scale * nc * na, triangle.c, triangle.a);
    decide(weights.c, scale * na * nb, triangle.a, triangle.b);
    return weights;
}

EdgeWeights exactEdgeWeights(const Ray& ray, const Triangle& t) {
    return {edgeDeterminantExact(ray.origin, ray.direction, t.b, t.c),
            edgeDeterminantExact(ray.origin, ray.direction, t.c, t.a),
            edgeDeterminantExact(ray.origin, ray.direction, t.a, t.b), 0.0};
}

} // namespace

PlaneDistance::PlaneDistance(glm::vec3 origin, const Triangle& t) : triangle_(t) {
    const glm::dvec3 a(t.a);
    const glm::dvec3 ab = glm::dvec3(t.b) - a, ac = glm::dvec3(t.c) - a;
    const glm::dvec3 toA = a - glm::dvec3(origin);
    normal_ = glm::cross(ab, ac);
    numerator_ = glm::dot(normal_, toA);
    // The bound above is 2^-49 of the norms; 2^-29 of the value is wanted, here and below.
    norms_ = 0x1p-20 * maxNorm(ab) * maxNorm(ac);
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

bool intersect(const Ray& ray, const Triangle& triangle, TriangleHit& out) {
    // Repeated vertices are common in real files, tens of thousands in one place, and would be
    // decided by the exact determinants each time.
    if (triangle.a == triangle.b || triangle.b == triangle.c || triangle.c == triangle.a)
        return false;

    EdgeWeights weights = edgeWeights(ray, triangle);
    const bool positive = weights.a > 0.0 || weights.b > 0.0 || weights.c > 0.0;
    const bool negative = weights.a < 0.0 || weights.b < 0.0 || weights.c < 0.0;
    // Mixed: the line passes beside the triangle. All zero: it lies in its plane, or there is no
    // area; otherwise their sum, d . normal, is not zero and the line meets the plane in a point.
    if (positive == negative) return false;

    if (!PlaneDistance(ray.origin, triangle).at(ray.direction, out.t)) return false;

    // Weights of a tiny far triangle: 2^-22 of their sum has to be above their error.
    if (std::abs(weights.a + weights.b + weights.c) < 0x1p25 * weights.bound)
        weights = exactEdgeWeights(ray, triangle);
    const double sum = weights.a + weights.b + weights.c;
    out.u = (float) (weights.b / sum);
    out.v = (float) (weights.c / sum);
    return true;
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
    // A sum of finite magnitudes may overflow, a comparison per component cannot.
    for (int i = 0; i < 3; ++i)
        if (!(std::abs(ray.origin[i]) <= FLT_MAX && std::abs(ray.direction[i]) <= FLT_MAX))
            return false;
    return ray.direction != glm::vec3(0.0f);
}

} // namespace dirt
