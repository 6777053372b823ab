#include "core/trace/offset.h"

#include "core/trace/determinant.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace dirt {

glm::vec3 offsetOrigin(const Triangle& triangle, float u, float v, glm::vec3 direction) {
    const glm::dvec3 a(triangle.a), ab = glm::dvec3(triangle.b) - a,
                                    ac = glm::dvec3(triangle.c) - a;
    const glm::dvec3 point = a + ab * (double) u + ac * (double) v;
    glm::dvec3 normal = glm::cross(ab, ac);
    const double largest = std::max({std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)});
    if (largest == 0.0) return glm::vec3(point);

    double side = glm::dot(normal, glm::dvec3(direction)) < 0.0 ? -1.0 : 1.0;
    normal *= side / largest;
    // Rounding to float moves the point by at most 2^-24 |p|_1 along the normal (whose largest
    // component is 1), and the point's own error in double is far below that; so the first step
    // nearly always suffices. The exact sign has the last word.
    double step = 0x1p-23 * (std::abs(point.x) + std::abs(point.y) + std::abs(point.z));
    step = std::max(step, 0x1p-120);
    for (int i = 0; i < 64; ++i, step *= 2.0) {
        const glm::vec3 origin(point + normal * step);
        if (planeDeterminantExact(origin, triangle.a, triangle.b, triangle.c) * side > 0.0)
            return origin;
    }
    return glm::vec3(point);
}

} // namespace dirt
