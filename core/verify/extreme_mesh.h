#pragma once

#include "core/scene/origin.h"
#include "core/scene/scene.h"

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace dirt {

/// The box of all triangles.
Bounds boundsOf(const Mesh& mesh);

/// The longest edge of that box; 1 where all is one point.
double sizeOf(const Mesh& mesh);

/// Ids of at most \p most triangles, spread evenly over the mesh.
std::vector<uint32_t> sampleTriangles(const Mesh& mesh, uint32_t most);

/// Appends a grey material and says which it is.
uint32_t addGrey(Scene& scene);

/// Appends a vertex, and says which it is.
uint32_t addVertex(Mesh& mesh, glm::vec3 p);

/// Appends a triangle without normals and texture coordinates.
void addTriangle(Mesh& mesh, const Corners& corners, uint32_t material);
void addTriangle(Mesh& mesh, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
                 uint32_t material);

} // namespace dirt
