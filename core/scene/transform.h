#pragma once

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace dirt {

/// A turn by \p degrees about \p axis (of any length but 0; right-handed).
struct Rotation {
    double degrees = 0.0;
    glm::dvec3 axis{0.0, 0.0, 1.0};
};

/// Rotations by multiples of 90 degrees about a coordinate axis are exact.
glm::dmat3 rotationMatrix(const Rotation& rotation);

/// Scale, then rotation, then translation.
glm::dmat4 placement(const glm::dvec3& scale, const glm::dmat3& rotation,
                     const glm::dvec3& translation);

/// The matrix that takes normals along: the inverse transpose up to a positive factor, which also
/// exists where the transform flattens space.
glm::dmat3 normalMatrix(const glm::dmat3& m);

} // namespace dirt
