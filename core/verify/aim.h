#pragma once

#include "core/trace/ray.h"

#include <optional>

#include <glm/vec3.hpp>

namespace dirt {

/// A ray from near \p origin that passes exactly through \p target: per coordinate, the origin is
/// moved towards the target to the first value for which origin + direction = target holds
/// without rounding. None if that leaves no direction.
std::optional<Ray> aimAtPoint(glm::vec3 origin, glm::vec3 target);

/// A ray from near \p origin that passes exactly through the edge from \p a to \p b, at the point
/// that divides it in the ratio \p weightB : \p weightA (positive integers below 2^10). None
/// where floats do not allow it.
std::optional<Ray> aimAtEdge(glm::vec3 origin, glm::vec3 a, glm::vec3 b, int weightA, int weightB);

} // namespace dirt
