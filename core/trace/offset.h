#pragma once

#include "core/grid/geometry.h"

#include <glm/vec3.hpp>

namespace dirt {

/// Origin of a ray that leaves \p triangle at barycentric weights (u, v) (T5): the surface point,
/// moved along the geometric normal beyond its own rounding error, so that it lies exactly on the
/// side that \p direction points to. A triangle without area is left unmoved.
glm::vec3 offsetOrigin(const Triangle& triangle, float u, float v, glm::vec3 direction);

} // namespace dirt
