#pragma once

#include "core/grid/geometry.h"
#include "core/scene/scene.h"

#include <glm/vec3.hpp>

namespace dirt {

/// A vector of the grid frame on the world's axes, with the grid frame's length.
inline glm::dvec3 onWorldAxes(const GridFrame& frame, glm::vec3 v) {
    const glm::dvec3 q(v);
    if (frame.mode == ViewMode::full) return q;
    // The rotation's inverse is its transpose.
    return q.x * glm::dvec3(frame.right) + q.y * glm::dvec3(frame.down) +
           q.z * glm::dvec3(frame.forward);
}

/// A point of the grid frame in the coordinates of the scene's files, as near as float has it.
inline glm::dvec3 worldPosition(const Scene& scene, const GridFrame& frame, glm::vec3 p) {
    return scene.origin + glm::dvec3(frame.eye) + onWorldAxes(frame, p) / (double) frame.scale;
}

} // namespace dirt
