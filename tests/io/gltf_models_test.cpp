// Sample models of the glTF community, by what they are made to show.

#include "core/io/load.h"
#include "tests/io/test_scenes.h"

#include <gtest/gtest.h>

#include <set>

#include <glm/geometric.hpp>

namespace dirt {
namespace {

namespace fs = std::filesystem;

class GltfModels : public testing::Test {
protected:
    /// Nothing where the model is not there.
    std::optional<LoadedScene> load(const std::string& name, const std::string& buffer) {
        const fs::path file = modelsFolder() / name / (name + ".gltf");
        const fs::path data = file.parent_path() / buffer;
        for (const fs::path& needed : {file, data})
            if (!fs::exists(needed)) {
                missing_ = "no " + needed.string();
                return std::nullopt;
            }
        return loadScene(file);
    }
    std::string missing_;
};

TEST_F(GltfModels, CamerasHasAPerspectiveAndAnOrthographicOne) {
    const auto loaded = load("Cameras", "simpleSquare.bin");
    if (!loaded) GTEST_SKIP() << missing_;
    ASSERT_EQ(loaded->cameras.size(), 2u);
    EXPECT_EQ(loaded->modelCamera, 0u);
    EXPECT_EQ(loaded->scene.camera.eye, glm::vec3(0.5f, 0.5f, 3.0f));
    EXPECT_EQ(loaded->cameras[1].halfHeight, 1.0);
    // Both look at the middle of the square.
    const Camera& second = loaded->cameras[1].camera;
    EXPECT_EQ(glm::vec2(second.eye), glm::vec2(0.5f));
    EXPECT_EQ(glm::vec2(second.target), glm::vec2(0.5f));
}

TEST_F(GltfModels, BoxVertexColorsHasTheColoursOfItsCorners) {
    const auto loaded = load("BoxVertexColors", "buffer.bin");
    if (!loaded) GTEST_SKIP() << missing_;
    const Mesh& mesh = loaded->scene.mesh;
    ASSERT_EQ(mesh.colors.size(), mesh.positions.size());
    const auto colourAt = [&](glm::vec3 corner) {
        for (size_t i = 0; i < mesh.positions.size(); ++i)
            if (glm::length(mesh.positions[i] - corner) < 1e-3f) return mesh.colors[i];
        return glm::vec3(-1.0f);
    };
    // As the file has them to a hundredth.
    const std::pair<glm::vec3, glm::vec3> corners[] = {{{-0.5f, -0.5f, -0.5f}, {1, 0, 0.024f}},
                                                       {{-0.5f, 0.5f, 0.5f}, {0.511f, 1, 0}},
                                                       {{0.5f, -0.5f, 0.5f}, {0, 0.131f, 1}},
                                                       {{0.5f, 0.5f, 0.5f}, {1, 0, 0.025f}}};
    for (const auto& [corner, colour] : corners)
        EXPECT_LT(glm::length(colourAt(corner) - colour), 0.01f);
}

TEST_F(GltfModels, MetalRoughSpheresChangeInMetalAndRoughness) {
    const auto loaded = load("MetalRoughSpheres", "MetalRoughSpheres0.bin");
    if (!loaded) GTEST_SKIP() << missing_;
    const Scene& scene = loaded->scene;
    const Material& material = scene.materials.at(0);
    ASSERT_NE(material.roughnessMap, kNoTexture);
    ASSERT_NE(material.metallicMap, kNoTexture);
    EXPECT_EQ(material.roughness, 1.0f);
    EXPECT_EQ(material.metallic, 1.0f);
    EXPECT_EQ(material.reflectance, 0.04f);
    std::set<int> roughness, metallic; // in tenths
    for (const glm::vec2& uv : scene.mesh.texcoords) {
        const auto tenths = [&](uint32_t map) {
            return (int) std::lround(10.0f * scene.scalarTextures[map].sample(uv));
        };
        roughness.insert(tenths(material.roughnessMap));
        metallic.insert(tenths(material.metallicMap));
    }
    // Eleven columns of roughness; rows from metal to none.
    EXPECT_GE(roughness.size(), 9u);
    EXPECT_TRUE(metallic.contains(0) && metallic.contains(10));
}

/// What is seen of a material in the plane z = 0 at (x, y).
glm::vec3 colourAt(const Scene& scene, uint32_t material, glm::dvec2 at) {
    const Mesh& mesh = scene.mesh;
    const auto area = [](glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; };
    for (size_t i = 0; i < mesh.triangles.size(); ++i) {
        if (mesh.materials[i] != material) continue;
        glm::dvec2 p[3];
        for (size_t k = 0; k < 3; ++k) p[k] = glm::dvec2(mesh.positions[mesh.triangles[i][k]]) - at;
        const double w[3] = {area(p[1], p[2]), area(p[2], p[0]), area(p[0], p[1])};
        const double sum = w[0] + w[1] + w[2];
        if (sum == 0.0 || w[0] / sum < 0.0 || w[1] / sum < 0.0 || w[2] / sum < 0.0) continue;
        glm::dvec2 uv(0.0);
        for (size_t k = 0; k < 3; ++k)
            uv += w[k] / sum * glm::dvec2(mesh.texcoords[mesh.texcoordIndices[i][k]]);
        const Material& m = scene.materials[material];
        return scene.textures[m.diffuseMap].sample(glm::vec2(uv)) * m.diffuseMapFactor;
    }
    ADD_FAILURE() << "nothing at " << at.x << ", " << at.y;
    return {};
}

/// In each row the sign on the left, which its sampler makes, is the one on the right, which the
/// texture has there by itself.
TEST_F(GltfModels, TextureSettingsTestPassesInAllRowsOfSamplers) {
    const auto loaded = load("TextureSettingsTest", "TextureSettingsTest0.bin");
    if (!loaded) GTEST_SKIP() << missing_;
    const Scene& scene = loaded->scene;
    struct Row {
        const char* material;
        double bottom;
    };
    constexpr double kSize = 0.9, kTest = 0.005, kPassed = 2.151;
    for (const Row& row :
         {Row{"TextureMirrorMaterialT", -5.165}, Row{"TextureMirrorMaterialS", -4.128},
          Row{"TextureRepeatMaterialT", -3.091}, Row{"TextureRepeatMaterialS", -2.054},
          Row{"TextureClampMaterialT", -1.020}, Row{"TextureClampMaterialS", 0.017}}) {
        uint32_t material = 0;
        while (scene.materials.at(material).name != row.material) ++material;
        constexpr int kSteps = 20;
        int red = 0, green = 0, alike = 0;
        for (int i = 1; i < kSteps; ++i)
            for (int j = 1; j < kSteps; ++j) {
                const glm::dvec2 inside(kSize * i / kSteps, kSize * j / kSteps);
                const glm::vec3 test =
                    colourAt(scene, material, glm::dvec2(kTest, row.bottom) + inside);
                const glm::vec3 passed =
                    colourAt(scene, material, glm::dvec2(kPassed, row.bottom) + inside);
                red += test.r > test.g + 0.3f;
                green += test.g > test.r + 0.3f;
                alike += glm::length(test - passed) < 0.3f;
            }
        EXPECT_EQ(red, 0) << row.material;
        EXPECT_GT(green, 10) << row.material;
        // The texture's two signs are drawn alike to a texel or two of some fifty.
        EXPECT_GT(alike, (kSteps - 1) * (kSteps - 1) * 3 / 4) << row.material;
    }
    // Whether surfaces have one side is for scene files to say; that the file says so is named.
    EXPECT_EQ(loaded->ignored, std::vector<std::string>{"glTF material doubleSided false"});
}

} // namespace
} // namespace dirt
