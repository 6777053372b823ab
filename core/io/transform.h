#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace dirt {

/// Scale, then rotation by \p degrees about \p axis (of any length but 0; right-handed), then
/// translation. Rotations by multiples of 90 degrees about a coordinate axis are exact.
glm::dmat4 placement(const glm::dvec3& scale, double degrees, const glm::dvec3& axis,
                     const glm::dvec3& translation);

} // namespace dirt
