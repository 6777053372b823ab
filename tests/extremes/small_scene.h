#pragma once

#include "core/frame/settings.h"
#include "core/verify/extreme_mesh.h"

#include <cmath>

#include <glm/geometric.hpp>

namespace dirt::test {

/// A lit room with a ball of 200 triangles and a table whose legs are thin, seen from a corner:
/// small enough that all variants of it take seconds.
inline Scene smallScene() {
    Scene scene;
    scene.name = "small";
    scene.materials.resize(2);
    scene.materials[1].reflectance = 0.5f;
    scene.materials[1].roughness = 0.1f;
    Mesh& mesh = scene.mesh;
    const auto box = [&](glm::dvec3 low, glm::dvec3 high, uint32_t material) {
        const auto at = [&](int k) {
            return glm::dvec3(k & 1 ? high.x : low.x, k & 2 ? high.y : low.y,
                              k & 4 ? high.z : low.z);
        };
        for (const auto& [a, b, c, d] : {std::array{0, 1, 3, 2},
                                         {4, 5, 7, 6},
                                         {0, 1, 5, 4},
                                         {2, 3, 7, 6},
                                         {0, 2, 6, 4},
                                         {1, 3, 7, 5}}) {
            addTriangle(mesh, at(a), at(b), at(c), material);
            addTriangle(mesh, at(a), at(c), at(d), material);
        }
    };
    box({-3.1, -1.7, -4.3}, {2.9, 2.3, 3.7}, 0);
    box({-1.0, -0.7, -2.0}, {1.2, -0.65, -0.9}, 1);
    for (const double x : {-0.9, 1.1})
        for (const double z : {-1.9, -1.0})
            box({x - 0.01, -1.7, z - 0.01}, {x + 0.01, -0.7, z + 0.01}, 0);
    const auto point = [](int column, int row) {
        const double theta = 0.31415926535 * row, phi = 0.62831853071 * (column % 10);
        return glm::dvec3(0.1, 0.02, -1.4) + 0.6 * glm::dvec3(std::sin(theta) * std::cos(phi),
                                                              std::cos(theta),
                                                              std::sin(theta) * std::sin(phi));
    };
    for (int row = 0; row < 10; row++)
        for (int column = 0; column < 10; column++) {
            addTriangle(mesh, point(column, row), point(column + 1, row),
                        point(column + 1, row + 1), 1);
            addTriangle(mesh, point(column, row), point(column + 1, row + 1),
                        point(column, row + 1), 1);
        }
    scene.camera = {.eye = {-2.3f, 1.1f, 2.9f}, .target = {0.3f, -0.6f, -1.5f}};
    Spotlight light;
    light.position = {1.7f, 2.1f, 1.3f}, light.target = {0.0f, -1.0f, -1.5f};
    light.flux = 50.0f;
    scene.lights = {light};
    scene.background = glm::vec3(0.5f);
    return scene;
}

/// As `verify --extremes` has them, smaller.
inline RenderSettings smallSettings() {
    RenderSettings settings;
    settings.grid.width = settings.grid.height = 32;
    settings.grid.tile = 4, settings.grid.bins = 8;
    return settings;
}

} // namespace dirt::test
