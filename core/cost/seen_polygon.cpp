#include "core/cost/seen_polygon.h"

#include "shaders/shared/margins.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace dirt {

namespace {

/// Keeps what is inside of the plane through the eye with this inward normal.
void clip(SeenPolygon& polygon, glm::dvec3 normal) {
    SeenPolygon kept;
    for (int i = 0; i < polygon.count; ++i) {
        const glm::dvec3 a = polygon.corners[i], b = polygon.corners[(i + 1) % polygon.count];
        const double da = glm::dot(normal, a), db = glm::dot(normal, b);
        if (da >= 0.0) kept.corners[kept.count++] = a;
        if ((da < 0.0 && db > 0.0) || (da > 0.0 && db < 0.0))
            kept.corners[kept.count++] = a + (b - a) * (da / (da - db));
    }
    polygon.count = kept.count;
    polygon.corners = kept.corners;
}

} // namespace

glm::dvec3 SeenPolygon::low() const {
    glm::dvec3 low = corners[0];
    for (int i = 1; i < count; ++i) low = glm::min(low, corners[i]);
    low.z *= 1.0 - kDepthMargin;
    return low;
}

glm::dvec3 SeenPolygon::high() const {
    glm::dvec3 high = corners[0];
    for (int i = 1; i < count; ++i) high = glm::max(high, corners[i]);
    high.z *= 1.0 + kDepthMargin;
    return high;
}

double SeenPolygon::area(int axis, int other) const {
    double twice = 0.0;
    for (int i = 1; i + 1 < count; ++i) {
        const glm::dvec3 a = corners[i] - corners[0], b = corners[i + 1] - corners[0];
        twice += a[axis] * b[other] - a[other] * b[axis];
    }
    return std::abs(twice) / 2.0;
}

SeenPolygon seenPolygon(const std::array<glm::dvec3, 3>& triangle, double rimX, double rimY) {
    SeenPolygon seen;
    // Most triangles are seen by one view: those wholly outside of a side go first.
    const std::array<glm::dvec3, 4> sides{glm::dvec3(1, 0, rimX), glm::dvec3(-1, 0, rimX),
                                          glm::dvec3(0, 1, rimY), glm::dvec3(0, -1, rimY)};
    bool inside = true;
    for (const glm::dvec3& side : sides) {
        int beyond = 0;
        for (const glm::dvec3& corner : triangle) beyond += glm::dot(side, corner) < 0.0;
        if (beyond == 3) return seen;
        inside = inside && beyond == 0;
    }
    seen.count = 3;
    std::copy(triangle.begin(), triangle.end(), seen.corners.begin());
    if (!inside)
        for (const glm::dvec3& side : sides) clip(seen, side);

    double farthest = 0.0;
    for (int i = 0; i < seen.count; ++i) farthest = std::max(farthest, seen.corners[i].z);
    if (!(farthest > 0.0)) {
        seen.count = 0;
        return seen;
    }
    for (int i = 0; i < seen.count; ++i) {
        glm::dvec3& corner = seen.corners[i];
        const double w = std::max(corner.z, farthest * 1e-9); // a triangle through the eye
        corner = {glm::clamp(corner.x / w, -rimX, rimX), glm::clamp(corner.y / w, -rimY, rimY), w};
    }
    const glm::dvec3 normal = glm::cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
    const double offset = glm::dot(normal, triangle[0]);
    if (offset != 0.0) seen.inverseDepth = normal / offset;
    return seen;
}

} // namespace dirt
