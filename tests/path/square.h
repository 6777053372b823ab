#pragma once

#include "tests/frame/shapes.h"

#include <vector>

#include <glm/vec2.hpp>

/// A square that textures are put on in different ways.
namespace dirt::test {

/// Texture coordinates of its corners.
inline const std::vector<glm::vec2> kUpright = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
inline const std::vector<glm::vec2> kMirrored = {{1, 0}, {0, 0}, {0, 1}, {1, 1}}; // u along -x
/// u along y, v along -x.
inline const std::vector<glm::vec2> kTurned = {{0, 1}, {0, 0}, {1, 0}, {1, 1}};

/// From the eye to a point of the square.
inline const glm::vec3 kTowards(0.1f, 0.2f, -1.0f);

/// In the plane z = -2, facing the eye.
inline Scene square(const std::vector<glm::vec2>& texcoords) {
    Scene scene;
    scene.materials = {material(glm::vec3(0.5f))};
    addQuad(scene.mesh, {-1, -1, -2}, {2, 0, 0}, {0, 2, 0}, 0);
    scene.mesh.texcoords = texcoords;
    scene.mesh.texcoordIndices = {{0, 1, 2}, {0, 2, 3}};
    scene.camera.eye = glm::vec3(0.0f);
    return scene;
}

} // namespace dirt::test
