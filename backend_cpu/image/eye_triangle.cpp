#include "backend_cpu/image/eye_triangle.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace dirt {
namespace {

double sum(const glm::dvec3& v) {
    return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
}
double largest(const glm::dvec3& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

} // namespace

EyeTriangle::EyeTriangle(const Triangle& triangle, uint32_t id, const PixelRange& range,
                         const EyeRays& rays)
    : id(id), range(range) {
    const glm::dvec3 a(triangle.a), b(triangle.b), c(triangle.c);
    const glm::dvec3 ab = b - a, ac = c - a;
    const glm::dvec3 normal = glm::cross(ab, ac);
    const double determinant = glm::dot(a, normal);
    const double length = std::max(largest(ab), largest(ac));
    const double size = std::max({largest(a), largest(b), largest(c)});
    clear = std::abs(determinant) > 0x1p-22 * length * length * size; // as in the header

    const double sign = determinant < 0.0 ? -1.0 : 1.0;
    const glm::dvec3 edges[3] = {glm::cross(b, c), glm::cross(c, a), glm::cross(a, b)};
    for (int i = 0; i < 3; ++i) {
        const double norm = sum(edges[i]);
        const double scale = norm > 0.0 ? sign / norm : 0.0;
        for (int k = 0; k < 3; ++k) edge[i][k] = (float) (edges[i][k] * scale);
    }
    const glm::dvec3 g = clear ? normal / determinant : glm::dvec3(0.0);
    for (int k = 0; k < 3; ++k) inverse[k] = (float) g[k];
    error = clear ? 0x1p-21f * rays.reach * (float) sum(g) : HUGE_VALF; // 8 u

    const double depth =
        std::min({glm::dot(a, rays.forward), glm::dot(b, rays.forward), glm::dot(c, rays.forward)});
    near = depth > 0.0 ? (float) (depth / rays.most * (1.0 - 0x1p-20)) : 0.0f; // rounded
}

bool EyeTriangle::misses(const glm::vec3 (&corners)[4], float spread) const {
    bool before = false, behind = false; // some edge has all on one side
    for (const auto& n : edge) {
        float least = HUGE_VALF, most = -HUGE_VALF;
        for (const glm::vec3& d : corners) {
            const float value = (n[0] * d.x + n[1] * d.y) + n[2] * d.z;
            least = std::min(least, value);
            most = std::max(most, value);
        }
        before |= most < -spread;
        behind |= least > spread;
    }
    return before && (clear || behind);
}

} // namespace dirt
