// Normal, roughness and metallic maps, factors and vertex colours on flat quads, against closed
// form.

#include "core/path/fetch_surface.h"
#include "shaders/shared/glossy_reflection.h"
#include "shaders/shared/random.h"
#include "shaders/shared/surface.h"
#include "tests/path/square.h"

#include <cfloat>
#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace dirt {
namespace {

using test::kMirrored, test::kTowards, test::kTurned, test::kUpright, test::square;

/// A square with a normal map that is \p normal everywhere, in floats.
Scene mapped(const std::vector<glm::vec2>& texcoords, glm::vec3 normal) {
    Scene scene = square(texcoords);
    const glm::vec3 c = normal * 0.5f + 0.5f;
    scene.textures = {Texture("n", 1, 1, std::vector<float>{c.x, c.y, c.z})};
    scene.materials[0].normalMap = 0;
    return scene;
}

SurfacePoint pointOf(const Scene& scene, glm::vec3 direction = kTowards, float u = 0.4f,
                     float v = 0.3f) {
    const FrameGeometry geometry = makeFrameGeometry(scene.mesh, scene.camera, ViewMode::full);
    return fetchSurface(scene, geometry, direction, 0, u, v);
}

void expectNormal(const Scene& scene, glm::vec3 wanted, glm::vec3 direction = kTowards) {
    const glm::vec3 found = pointOf(scene, direction).shadingNormal;
    // Some ten roundings of numbers up to 1.
    EXPECT_LT(glm::length(found - glm::normalize(wanted)), 10 * FLT_EPSILON)
        << found.x << " " << found.y << " " << found.z;
}

TEST(NormalMaps, StandInTheImagesFrame) {
    const glm::vec3 tilted(0.5f, 0.25f, 0.75f);
    expectNormal(mapped(kUpright, tilted), {0.5f, 0.25f, 0.75f});
    expectNormal(mapped(kMirrored, tilted), {-0.5f, 0.25f, 0.75f});
    expectNormal(mapped(kTurned, tilted), {-0.25f, 0.5f, 0.75f});
    expectNormal(mapped({{0, 0}, {1, 0}, {1, -1}, {0, -1}}, tilted), {0.5f, -0.25f, 0.75f});
}

TEST(NormalMaps, FollowTransforms) {
    Scene scene = mapped(kUpright, {0.5f, 0.25f, 0.75f});
    TextureSampling turned;
    turned.transformed = true;
    turned.rowU = {0, 3, 7}; // the image's u runs along the mesh's v, its v along -u
    turned.rowV = {-2, 0, 1};
    scene.textures[0] = scene.textures[0].with(turned);
    expectNormal(scene, {-0.25f, 0.5f, 0.75f});
    turned.rowU = {-1, 0, 0}; // mirrored
    turned.rowV = {0, 1, 0};
    scene.textures[0] = scene.textures[0].with(turned);
    expectNormal(scene, {-0.5f, 0.25f, 0.75f});
}

TEST(NormalMaps, SeenFromBehindAreTheOtherWayRound) {
    expectNormal(mapped(kUpright, {0.5f, 0.25f, 0.75f}), {-0.5f, -0.25f, -0.75f}, {0, 0, 1});
    expectNormal(mapped(kMirrored, {0.5f, 0.25f, 0.75f}), {0.5f, -0.25f, -0.75f}, {0, 0, 1});
}

TEST(NormalMaps, AreScaledAcross) {
    Scene scene = mapped(kUpright, {0.5f, 0.25f, 0.75f});
    scene.materials[0].normalScale = 0.5f;
    expectNormal(scene, {0.25f, 0.125f, 0.75f});
    scene.materials[0].normalScale = 0.0f;
    expectNormal(scene, {0, 0, 1});
}

TEST(NormalMaps, TurnInterpolatedNormals) {
    Scene scene = mapped(kUpright, {0.5f, 0.25f, 0.75f});
    const glm::vec3 n = glm::normalize(glm::vec3(0.3f, 0, 1));
    scene.mesh.normals = {n};
    scene.mesh.normalIndices = {{0, 0, 0}, {0, 0, 0}};
    const glm::vec3 u = glm::normalize(glm::vec3(1, 0, -0.3f));
    expectNormal(scene, 0.5f * u + 0.25f * glm::vec3(0, 1, 0) + 0.75f * n);
}

TEST(NormalMaps, FlatOnesOfBytesTiltByHalfAStep) {
    Scene scene = square(kUpright);
    scene.textures = {
        Texture("n", 1, 1, std::vector<uint8_t>{128, 128, 255}, TexelEncoding::linear)};
    scene.materials[0].normalMap = 0;
    expectNormal(scene, {1.0f / 255.0f, 1.0f / 255.0f, 1}); // 2 * 128 / 255 - 1
}

TEST(NormalMaps, ComeBeforeHeights) {
    Scene scene = mapped(kUpright, {0.5f, 0.25f, 0.75f});
    scene.scalarTextures = {ScalarTexture("h", 2, 2, std::vector<float>{0, 1, 0, 1})};
    scene.materials[0].bumpMap = 0;
    expectNormal(scene, {0.5f, 0.25f, 0.75f});
}

TEST(NormalMaps, NeedTextureCoordinates) {
    const glm::vec2 same(0.5f, 0.5f);
    expectNormal(mapped({same, same, same, same}, {0.5f, 0, 0.75f}), {0, 0, 1}); // without extent
    Scene scene = mapped(kUpright, {0.5f, 0, 0.75f});
    scene.mesh.texcoordIndices[0] = {kNoIndex, kNoIndex, kNoIndex};
    expectNormal(scene, {0, 0, 1});
}

TEST(Bumps, FollowTransforms) {
    Scene scene = square(kUpright);
    std::vector<float> ramp;
    for (int i = 0; i < 64; ++i) ramp.push_back(0.25f * (float) (i % 8));
    TextureSampling turned;
    turned.transformed = true;
    turned.rowU = {0, 1, 0};
    turned.rowV = {-1, 0, 1};
    scene.scalarTextures = {ScalarTexture("h", 8, 8, std::move(ramp)).with(turned)};
    scene.materials[0].bumpMap = 0;
    expectNormal(scene, {0, -0.25f, 1});
}

float reflectanceOf(const SurfacePoint& point) {
    return (float) (point.gloss & 0xffffu) / 65535.0f;
}
float metallicOf(const SurfacePoint& point) {
    return (float) (point.gloss >> 16u) / 65535.0f;
}
constexpr float kHalfStep = 0.5f / 65535.0f + FLT_EPSILON;

TEST(RoughnessMaps, WidenByTheirSquare) {
    Scene scene = square(kUpright);
    Material& material = scene.materials[0];
    material.reflectance = 0.5f;
    material.roughness = 0.75f;
    scene.scalarTextures = {ScalarTexture("r", 1, 1, std::vector<float>{0.5f}),
                            ScalarTexture("r", 1, 1, std::vector<float>{7.0f})};
    EXPECT_EQ(pointOf(scene).roughness, 0.75f);
    material.roughnessMap = 0;
    EXPECT_EQ(pointOf(scene).roughness, 0.1875f);
    material.roughnessMap = 1;
    EXPECT_EQ(pointOf(scene).roughness, 1.0f);
}

TEST(MetallicMaps, ReflectMoreWhereTheyAreMetal) {
    Scene scene = square(kUpright);
    Material& material = scene.materials[0];
    material.reflectance = 0.04f;
    material.metallic = 0.5f;
    scene.scalarTextures = {ScalarTexture("m", 1, 1, std::vector<float>{0.5f}),
                            ScalarTexture("m", 1, 1, std::vector<float>{-1.0f})};
    EXPECT_NEAR(reflectanceOf(pointOf(scene)), 0.04f, kHalfStep); // as it is, without a map
    EXPECT_NEAR(metallicOf(pointOf(scene)), 0.5f, kHalfStep);
    material.metallicMap = 0;
    EXPECT_NEAR(reflectanceOf(pointOf(scene)), 0.04f + 0.96f * 0.25f, kHalfStep);
    EXPECT_NEAR(metallicOf(pointOf(scene)), 0.25f, kHalfStep);
    material.metallicMap = 1;
    EXPECT_NEAR(reflectanceOf(pointOf(scene)), 0.04f, kHalfStep);
    EXPECT_EQ(metallicOf(pointOf(scene)), 0.0f);
    scene.mesh.texcoordIndices[0] = {kNoIndex, kNoIndex, kNoIndex}; // metal throughout
    EXPECT_NEAR(reflectanceOf(pointOf(scene)), 0.04f + 0.96f * 0.5f, kHalfStep);
}

TEST(DiffuseMaps, AreMultipliedByFactorAndVertexColours) {
    Scene scene = square(kUpright);
    scene.textures = {Texture("t", 1, 1, std::vector<float>{0.5f, 0.25f, 1.0f})};
    scene.materials[0].diffuseMapFactor = {0.5f, 2.0f, 0.25f};
    EXPECT_EQ(pointOf(scene).diffuse, glm::vec3(0.5f)); // of a map, which there is none of
    scene.materials[0].diffuseMap = 0;
    EXPECT_EQ(pointOf(scene).diffuse, glm::vec3(0.25f, 0.5f, 0.25f));
    scene.mesh.colors.assign(scene.mesh.positions.size(), glm::vec3(0));
    scene.mesh.colors[0] = {1, 1, 1};
    scene.mesh.colors[1] = {0, 1, 0.5f};
    scene.mesh.colors[2] = {1, 0, 0.5f};
    EXPECT_EQ(pointOf(scene, kTowards, 0.25f, 0.5f).diffuse,
              glm::vec3(0.25f * 0.75f, 0.5f * 0.5f, 0.25f * 0.625f));
    scene.materials[0].diffuseMap = kNoTexture;
    EXPECT_EQ(pointOf(scene, kTowards, 0.25f, 0.5f).diffuse, 0.5f * glm::vec3(0.75f, 0.5f, 0.625f));
}

/// A point whose shading normal is any, seen from anywhere in front of its surface.
SurfacePoint anyPoint(uint32_t i, glm::vec3 v) {
    const auto direction = [i](uint32_t k) {
        return glm::vec3(randomUnit(i, k, 0, 0, 0), randomUnit(i, k, 0, 1, 0),
                         randomUnit(i, k, 0, 2, 0)) *
                   2.0f -
               1.0f;
    };
    SurfacePoint point;
    point.geometricNormal = facing(directionOf(direction(0)), v);
    point.shadingNormal = shadingNormalFrom(direction(1), point.geometricNormal);
    return point;
}

TEST(NormalSeenFrom, MirrorsOutOfTheSurface) {
    int kept = 0, bent = 0;
    for (uint32_t i = 0; i < 100000; ++i) {
        glm::vec3 v =
            directionOf({randomUnit(i, 2, 0, 0, 0) - 0.5f, randomUnit(i, 2, 0, 1, 0) - 0.5f,
                         randomUnit(i, 2, 0, 2, 0) - 0.5f});
        SurfacePoint point = anyPoint(i, v);
        if (i % 4 == 0) // at grazing angles
            v = directionOf(v -
                            point.geometricNormal * (glm::dot(point.geometricNormal, v) *
                                                     (1.0f - randomUnit(i, 3, 0, 0, 0) * 0x1p-8f)));
        const glm::vec3 g = point.geometricNormal;
        const float viewer = glm::dot(g, v);
        if (!(viewer > 0x1p-20f)) continue;
        const glm::vec3 n = normalSeenFrom(point, v);
        const glm::vec3 mirrored = n * (2.0f * glm::dot(n, v)) - v;
        EXPECT_GE(glm::dot(n, v), 0.999f * kLeastCosine) << i;
        EXPECT_GT(glm::dot(g, mirrored), 0.25f * std::min(viewer, 2 * kLeastCosine)) << i;
        EXPECT_NEAR(glm::length(n), 1.0f, 4 * FLT_EPSILON);
        const glm::vec3 before = point.shadingNormal;
        const bool seen = glm::dot(before, v) >= kLeastCosine;
        const glm::vec3 was = before * (2.0f * glm::dot(before, v)) - v;
        if (seen && glm::dot(g, was) >= 2 * kLeastCosine) {
            EXPECT_EQ(n, before); // nothing to mend
            ++kept;
        } else {
            ++bent;
        }
        point.shadingNormal = g;
        if (viewer >= kLeastCosine) {
            EXPECT_EQ(normalSeenFrom(point, v), g) << i;
        }
    }
    EXPECT_GT(kept, 10000);
    EXPECT_GT(bent, 10000);
}

} // namespace
} // namespace dirt
