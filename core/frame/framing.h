#pragma once

#include "core/grid/geometry.h"

#include <optional>
#include <span>

#include <glm/vec3.hpp>

namespace dirt {

/// A picture's axes and shape.
struct Framing {
    glm::dvec3 right, down, forward; ///< unit vectors
    double wide, tall;               ///< half of its width and height, at a distance of 1

    /// Looks along \p direction. Where that is along \p up, any roll will do.
    Framing(glm::dvec3 direction, glm::vec3 up, float verticalFov, float aspect);

    /// Whether \p point is in the picture that is taken from \p eye.
    bool contains(glm::dvec3 point, glm::dvec3 eye) const;

    /// The nearest place from which all \p points fill the middle nine tenths of the picture (the
    /// safe area of television), in its middle, or with \p target in its middle. Where the points
    /// are all one, at a distance of 1.
    glm::dvec3 eyeFor(std::span<const glm::dvec3> points,
                      std::optional<glm::dvec3> target = {}) const;
};

} // namespace dirt
