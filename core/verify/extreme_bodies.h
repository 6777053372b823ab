#pragma once

#include "core/scene/scene.h"

#include <array>

namespace dirt {

/// A closed, lightless box around the scene and its eye, a light and a bright background outside.
/// Shared: twelve triangles over eight corners. Else the walls are wider than the box and pass
/// through each other, so that no two of them share a corner or an edge.
void encloseInBox(Scene& scene, bool shared);

/// The corners of the room inside that box: of its last twelve triangles.
struct Room {
    glm::vec3 low, high;
};
Room roomOf(const Mesh& mesh);

/// In place of the scene, as large, a ball of 80 triangles with a light and the eye outside: convex
/// beyond rounding, no two faces in one plane.
void replaceByBall(Scene& scene);

} // namespace dirt
