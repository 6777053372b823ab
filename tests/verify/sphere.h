#pragma once

#include "core/scene/scene.h"

#include <cmath>
#include <cstdint>
#include <numbers>

namespace dirt::test {

/// A sphere of columns x rows quads, two triangles each, computed in double and rounded once to
/// float. At the poles one triangle of each quad has no area. Rows and columns share vertices, so
/// the mesh is closed, wherever rounding puts them.
inline Mesh sphere(int columns, int rows, double radius, glm::dvec3 centre) {
    Mesh mesh;
    for (int row = 0; row <= rows; row++) {
        for (int column = 0; column < columns; column++) {
            const double theta = std::numbers::pi * row / rows;
            const double phi = 2.0 * std::numbers::pi * column / columns;
            const double r = row == 0 || row == rows ? 0.0 : radius * std::sin(theta);
            mesh.positions.push_back(glm::vec3(glm::dvec3(centre.x + r * std::cos(phi),
                                                          centre.y + radius * std::cos(theta),
                                                          centre.z + r * std::sin(phi))));
        }
    }
    for (int row = 0; row < rows; row++) {
        for (int column = 0; column < columns; column++) {
            const auto vertex = [&](int i, int j) {
                return (uint32_t) ((row + i) * columns + (column + j) % columns);
            };
            mesh.triangles.push_back({vertex(0, 0), vertex(0, 1), vertex(1, 1)});
            mesh.triangles.push_back({vertex(0, 0), vertex(1, 1), vertex(1, 0)});
        }
    }
    mesh.materials.resize(mesh.triangles.size(), 0);
    return mesh;
}

} // namespace dirt::test
