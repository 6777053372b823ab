#pragma once

#include "core/grid/geometry.h"
#include "core/scene/scene.h"

#include <array>
#include <cmath>

#include <glm/geometric.hpp>

namespace dirt::test {

/// Adds a triangle of \p material, without normals and texture coordinates.
inline void addTriangle(Mesh& mesh, glm::vec3 a, glm::vec3 b, glm::vec3 c, uint32_t material) {
    const uint32_t first = (uint32_t) mesh.positions.size();
    mesh.positions.insert(mesh.positions.end(), {a, b, c});
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.normalIndices.push_back({kNoIndex, kNoIndex, kNoIndex});
    mesh.texcoordIndices.push_back({kNoIndex, kNoIndex, kNoIndex});
    mesh.materials.push_back(material);
}

/// Adds the parallelogram at \p corner with sides \p u and \p v.
inline void addQuad(Mesh& mesh, glm::vec3 corner, glm::vec3 u, glm::vec3 v, uint32_t material) {
    addTriangle(mesh, corner, corner + u, corner + u + v, material);
    addTriangle(mesh, corner, corner + u + v, corner + v, material);
}

/// Adds the six sides of an axis-aligned box.
inline void addBox(Mesh& mesh, glm::vec3 low, glm::vec3 high, uint32_t material) {
    const glm::vec3 x(high.x - low.x, 0, 0), y(0, high.y - low.y, 0), z(0, 0, high.z - low.z);
    addQuad(mesh, low, x, y, material);
    addQuad(mesh, low, y, z, material);
    addQuad(mesh, low, z, x, material);
    addQuad(mesh, low + z, x, y, material);
    addQuad(mesh, low + x, y, z, material);
    addQuad(mesh, low + y, z, x, material);
}

/// Adds a sphere of 2 x \p rings x \p rings quads, with its exact normals if \p smooth.
inline void addSphere(Mesh& mesh, glm::vec3 center, float radius, int rings, bool smooth,
                      uint32_t material) {
    const auto direction = [rings](int ring, int step) {
        const double theta = M_PI * ring / rings, phi = M_PI * step / rings;
        return glm::vec3(std::sin(theta) * std::cos(phi), std::cos(theta),
                         std::sin(theta) * std::sin(phi));
    };
    const auto add = [&](std::array<glm::vec3, 3> n) {
        addTriangle(mesh, center + radius * n[0], center + radius * n[1], center + radius * n[2],
                    material);
        if (!smooth) return;
        const uint32_t first = (uint32_t) mesh.normals.size();
        mesh.normals.insert(mesh.normals.end(), n.begin(), n.end());
        mesh.normalIndices.back() = {first, first + 1, first + 2};
    };
    for (int ring = 0; ring < rings; ++ring)
        for (int step = 0; step < 2 * rings; ++step) {
            const glm::vec3 a = direction(ring, step), b = direction(ring + 1, step),
                            c = direction(ring + 1, step + 1), d = direction(ring, step + 1);
            if (ring + 1 < rings) add({a, b, c});
            if (ring > 0) add({a, c, d});
        }
}

/// A material of reflectance \p diffuse and radiance \p emission.
inline Material material(glm::vec3 diffuse, glm::vec3 emission = glm::vec3(0.0f)) {
    Material result;
    result.diffuse = diffuse;
    result.emission = emission;
    return result;
}

/// A scene of bare triangles around the origin, where the camera stands.
inline Scene sceneOf(const std::vector<Triangle>& triangles) {
    Scene scene;
    scene.materials = {material(glm::vec3(0.5f))};
    for (const Triangle& t : triangles) addTriangle(scene.mesh, t.a, t.b, t.c, 0);
    scene.camera.eye = glm::vec3(0.0f);
    return scene;
}

/// A room of 4 x 3 x 4 with coloured walls, a smooth ball and a box in it, an emissive panel and a
/// spotlight; the camera stands inside. Something of everything that the transport knows.
inline Scene room() {
    Scene scene;
    scene.name = "room";
    scene.materials = {material({0.7f, 0.7f, 0.7f}), material({0.7f, 0.2f, 0.1f}),
                       material({0.2f, 0.4f, 0.8f}),
                       material({0.0f, 0.0f, 0.0f}, {4.0f, 3.0f, 2.0f})};
    Mesh& mesh = scene.mesh;
    addQuad(mesh, {-2, 0, -2}, {4, 0, 0}, {0, 0, 4}, 0);       // floor
    addQuad(mesh, {-2, 0, -2}, {4, 0, 0}, {0, 3, 0}, 0);       // back
    addQuad(mesh, {-2, 0, -2}, {0, 3, 0}, {0, 0, 4}, 1);       // left
    addQuad(mesh, {2, 0, -2}, {0, 3, 0}, {0, 0, 4}, 2);        // right
    addQuad(mesh, {-0.5f, 2.5f, -1}, {1, 0, 0}, {0, 0, 1}, 3); // panel
    addSphere(mesh, {-0.8f, 0.6f, -0.5f}, 0.6f, 12, true, 0);
    addBox(mesh, {0.4f, 0, -1}, {1.2f, 1.4f, -0.2f}, 1);
    Spotlight light;
    light.position = {0.5f, 2.8f, 1.5f};
    light.target = {0, 0, -0.5f};
    light.flux = 30.0f;
    light.penumbra = 60.0f;
    scene.lights = {light};
    scene.background = {0.2f, 0.3f, 0.5f};
    scene.camera.eye = {0.1f, 1.3f, 1.9f};
    scene.camera.target = {0, 1, -1};
    scene.camera.verticalFov = 70.0f;
    return scene;
}

} // namespace dirt::test
