#include "core/scene/origin.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace dirt {

namespace {

constexpr double kFar = 128.0;

double largest(const glm::dvec3& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

} // namespace

glm::dvec3 originFor(const Bounds& bounds) {
    const glm::dvec3 size = bounds.high - bounds.low;
    const double edge = largest(size),
                 farthest = std::max(largest(bounds.low), largest(bounds.high));
    // Of a point no digit is lost that would tell it from another.
    if (!(edge > 0.0) || !(farthest > kFar * glm::length(size))) return glm::dvec3(0.0);
    const double step = std::ldexp(1.0, std::ilogb(edge) + 1);
    glm::dvec3 origin;
    for (int i = 0; i < 3; ++i)
        origin[i] = std::nearbyint((bounds.low[i] + 0.5 * size[i]) / step) * step + 0.0; // no -0
    return origin;
}

} // namespace dirt
