// Normals from heights, against the plane that the heights make.

#include "core/path/fetch_surface.h"
#include "tests/path/square.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace dirt {
namespace {

using test::kMirrored, test::kTowards, test::kTurned, test::kUpright, test::square;

constexpr int kTexels = 8;

/// A square whose heights grow by \p u and \p v for each texel.
Scene ramp(float u, float v, float bumpScale, const std::vector<glm::vec2>& texcoords) {
    Scene scene = square(texcoords);
    std::vector<float> heights;
    for (int y = 0; y < kTexels; ++y)
        for (int x = 0; x < kTexels; ++x)
            heights.push_back(u * (float) x + v * (float) (kTexels - 1 - y)); // rows downwards
    scene.scalarTextures = {ScalarTexture("ramp", kTexels, kTexels, std::move(heights))};
    scene.materials[0].bumpMap = 0;
    scene.materials[0].bumpScale = bumpScale;
    return scene;
}

glm::vec3 normalAt(const Scene& scene, glm::vec3 direction, float u = 0.4f, float v = 0.3f) {
    const FrameGeometry geometry = makeFrameGeometry(scene.mesh, scene.camera, ViewMode::full);
    return fetchSurface(scene, geometry, direction, 0, u, v).shadingNormal;
}

void expectNear(glm::vec3 found, glm::vec3 wanted) {
    // Some ten roundings of heights up to 4, differences of which count.
    EXPECT_LT(glm::length(found - glm::normalize(wanted)), 3e-6f)
        << found.x << " " << found.y << " " << found.z;
}

TEST(Bumps, HeightsTurnTheNormalAwayFromWhereTheyGrow) {
    expectNear(normalAt(ramp(0.25f, 0, 1, kUpright), kTowards), {-0.25f, 0, 1});
    expectNear(normalAt(ramp(0, 0.25f, 1, kUpright), kTowards), {0, -0.25f, 1});
    expectNear(normalAt(ramp(0.25f, -0.5f, 1, kUpright), kTowards), {-0.25f, 0.5f, 1});
}

TEST(Bumps, FollowTheTexture) {
    expectNear(normalAt(ramp(0.25f, 0, 1, kMirrored), kTowards), {0.25f, 0, 1});
    expectNear(normalAt(ramp(0.25f, 0, 1, kTurned), kTowards), {0, -0.25f, 1});
    expectNear(normalAt(ramp(0, 0.25f, 1, kTurned), kTowards), {0.25f, 0, 1});
}

TEST(Bumps, AreScaled) {
    expectNear(normalAt(ramp(0.25f, 0, -2, kUpright), kTowards), {0.5f, 0, 1});
    expectNear(normalAt(ramp(0.25f, 0.5f, 0, kUpright), kTowards), {0, 0, 1});
}

TEST(Bumps, SeenFromBehindAreTheOtherWayRound) {
    expectNear(normalAt(ramp(0.25f, 0, 1, kUpright), {0, 0, 1}), {0.25f, 0, -1});
}

TEST(Bumps, TurnInterpolatedNormals) {
    Scene scene = ramp(0.25f, 0, 1, kUpright);
    scene.mesh.normals = {glm::normalize(glm::vec3(0.3f, 0, 1))};
    scene.mesh.normalIndices = {{0, 0, 0}, {0, 0, 0}};
    // Along the tilted surface u goes to (1, 0, -0.3).
    const glm::vec3 along = glm::normalize(glm::vec3(1, 0, -0.3f));
    expectNear(normalAt(scene, kTowards), scene.mesh.normals[0] - 0.25f * along);
}

TEST(Bumps, NeedTextureCoordinates) {
    Scene scene = ramp(0.25f, 0, 1, {{0.5f, 0.5f}, {0.5f, 0.5f}, {0.5f, 0.5f}, {0.5f, 0.5f}});
    expectNear(normalAt(scene, kTowards), {0, 0, 1}); // without extent
    scene.mesh.texcoordIndices[0] = {kNoIndex, kNoIndex, kNoIndex};
    expectNear(normalAt(scene, kTowards), {0, 0, 1});
}

} // namespace
} // namespace dirt
