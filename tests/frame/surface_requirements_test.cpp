// What surfaces require: each of maps, transforms, wraps and colours by itself, and nothing where
// nothing has it.

#include "core/frame/requirements.h"
#include "tests/frame/shapes.h"

#include <algorithm>
#include <functional>

#include <gtest/gtest.h>

namespace dirt {
namespace {

/// A quad with a texture of colours and one of data.
Scene texturedQuad() {
    Scene scene;
    scene.materials = {test::material(glm::vec3(0.5f))};
    test::addQuad(scene.mesh, {-1, -1, -2}, {2, 0, 0}, {0, 2, 0}, 0);
    scene.mesh.texcoords = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    scene.mesh.texcoordIndices = {{0, 1, 2}, {0, 2, 3}};
    scene.textures = {Texture("c", 1, 1, std::vector<float>{0.5f, 0.5f, 1.0f})};
    scene.scalarTextures = {ScalarTexture("d", 1, 1, std::vector<float>{0.5f})};
    scene.materials[0].diffuseMap = 0;
    scene.materials[0].reflectance = 0.1f;
    scene.materials[0].reflectanceMap = 0;
    return scene;
}

/// Names of what is required.
std::vector<std::string> required(const Scene& scene) {
    const RenderSettings settings;
    std::vector<std::string> names;
    const Requirements need = requirementsOf(scene, settings, true);
    for (const RequirementReason& row : explain(need, scene, settings, true)) {
        EXPECT_FALSE(row.reason.empty()) << row.name;
        if (row.required) names.push_back(row.name);
    }
    return names;
}

/// What is required more after \p change.
std::vector<std::string> added(const std::function<void(Scene&)>& change) {
    Scene scene = texturedQuad();
    const std::vector<std::string> before = required(scene);
    change(scene);
    std::vector<std::string> names;
    for (const std::string& name : required(scene))
        if (std::find(before.begin(), before.end(), name) == before.end()) names.push_back(name);
    return names;
}

using Names = std::vector<std::string>;

TEST(SurfaceRequirements, AreEachOfItsOwn) {
    EXPECT_EQ(added([](Scene&) {}), Names());
    EXPECT_EQ(added([](Scene& s) { s.materials[0].normalMap = 0; }), Names{"normal maps"});
    EXPECT_EQ(added([](Scene& s) { s.materials[0].bumpMap = 0; }), Names{"bump maps"});
    EXPECT_EQ(added([](Scene& s) { s.materials[0].normalMap = s.materials[0].bumpMap = 0; }),
              Names{"normal maps"});
    EXPECT_EQ(added([](Scene& s) { s.materials[0].roughnessMap = 0; }),
              Names{"roughness textures"});
    EXPECT_EQ(added([](Scene& s) { s.materials[0].diffuseMapFactor.y = 0.5f; }),
              Names{"texture factors"});
    EXPECT_EQ(added([](Scene& s) { s.mesh.colors.assign(s.mesh.positions.size(), glm::vec3(1)); }),
              Names{"vertex colours"});
}

TEST(SurfaceRequirements, OfMetalComeWithMetal) {
    const auto metal = [](Scene& s) { s.materials[0].metallicMap = 0; };
    EXPECT_EQ(added(metal), Names()); // its factor is 0
    EXPECT_EQ(added([&](Scene& s) {
                  metal(s);
                  s.materials[0].metallic = 0.5f;
              }),
              Names{"metallic textures"});
    Scene scene = texturedQuad();
    scene.materials[0].reflectance = 0.0f;
    scene.materials[0].metallic = 1.0f;
    EXPECT_FALSE(requirementsOf(scene, {}, true).gloss);
    metal(scene);
    EXPECT_TRUE(requirementsOf(scene, {}, true).gloss);
}

TEST(SurfaceRequirements, OfTexturesAreOfThoseThatAreUsed) {
    TextureSampling clamp, moved;
    clamp.wrapV = Wrap::clamp;
    moved.transformed = true;
    for (const bool used : {false, true}) {
        const auto sampled = [&](const TextureSampling& sampling) {
            return added([&](Scene& s) {
                s.textures.push_back(s.textures[0].with(sampling));
                if (used) s.materials[0].diffuseMap = 1;
            });
        };
        EXPECT_EQ(sampled(clamp), used ? Names{"texture borders"} : Names());
        EXPECT_EQ(sampled(moved), used ? Names{"texture transforms"} : Names());
    }
    EXPECT_EQ(added([&](Scene& s) {
                  s.scalarTextures.push_back(s.scalarTextures[0].with(clamp));
                  s.materials[0].reflectanceMap = 1;
              }),
              Names{"texture borders"});
}

TEST(SurfaceRequirements, OfMapsNeedTextureCoordinates) {
    Scene scene = texturedQuad();
    TextureSampling clamp;
    clamp.wrapU = Wrap::clamp;
    scene.textures[0] = scene.textures[0].with(clamp);
    Material& m = scene.materials[0];
    m.normalMap = m.bumpMap = m.roughnessMap = 0;
    scene.mesh.texcoords.clear();
    EXPECT_EQ(required(scene), required([] {
                  Scene plain = texturedQuad();
                  plain.mesh.texcoords.clear();
                  return plain;
              }()));
}

} // namespace
} // namespace dirt
