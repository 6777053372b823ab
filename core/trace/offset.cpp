#include "core/trace/offset.h"

#include "core/trace/determinant.h"
#include "shaders/shared/margins.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace dirt {
namespace {

/// Normal of a triangle, scaled so that its largest |component| is 1; zero if there is no area.
glm::dvec3 scaledNormal(const Triangle& t) {
    const glm::dvec3 ab = glm::dvec3(t.b) - glm::dvec3(t.a), ac = glm::dvec3(t.c) - glm::dvec3(t.a);
    const auto largest = [](const glm::dvec3& v) {
        return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    };
    glm::dvec3 normal = glm::cross(ab, ac);
    // The components' error is below 2^-50 of the norms; a needle's normal is all error.
    if (largest(normal) <= kNeedle * largest(ab) * largest(ac))
        for (int i = 0; i < 3; ++i) {
            glm::vec3 axis(0.0f);
            axis[i] = 1.0f;
            normal[i] = directionDeterminantExact(axis, t.a, t.b, t.c);
        }
    const double length = largest(normal);
    return length > 0.0 ? normal / length : normal;
}

} // namespace

glm::vec3 offsetOrigin(const Triangle& triangle, float u, float v, glm::vec3 direction) {
    const glm::dvec3 point = glm::dvec3(triangle.a) * (1.0 - (double) u - (double) v) +
                             glm::dvec3(triangle.b) * (double) u +
                             glm::dvec3(triangle.c) * (double) v;
    glm::dvec3 normal = scaledNormal(triangle);
    if (normal == glm::dvec3(0.0)) return glm::vec3(point);

    const int side = directionSide(direction, triangle.a, triangle.b, triangle.c) < 0 ? -1 : 1;
    normal *= side;
    // Rounding to float moves the point by at most 2^-24 |p|_1 along the normal (whose largest
    // component is 1), and the point's own error in double is far below that; so the first step
    // nearly always suffices. The exact sign has the last word.
    double step = kOffsetStep * (std::abs(point.x) + std::abs(point.y) + std::abs(point.z));
    step = std::max(step, 0x1p-120); // beside the origin, far above denormals
    for (int i = 0; i < 64; ++i, step *= 2.0) {
        const glm::vec3 origin(point + normal * step);
        if (planeSide(origin, triangle.a, triangle.b, triangle.c) == side) return origin;
    }
    return glm::vec3(point);
}

} // namespace dirt
