// Which convention MTL files are taken by, who decides it, and that each object has its own.

#include "core/io/load.h"
#include "tests/io/input_error.h"
#include "tests/io/test_scenes.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace dirt {
namespace {

constexpr auto kDemo = MaterialConvention::demo;
constexpr auto kWavefront = MaterialConvention::wavefront;

class Convention : public testing::Test {
protected:
    void SetUp() override {
        folder_.write("a.mtl", "newmtl m\nKs .5 .5 .5\nNs 250\n");
        folder_.write("a.obj", "mtllib a.mtl\nusemtl m\n" + triangle_);
        folder_.write("metal.mtl", "newmtl m\nKs .5 .5 .5\nmetallic 1\n");
        folder_.write("metal.obj", "mtllib metal.mtl\nusemtl m\n" + triangle_);
    }

    LoadedScene load(const std::string& file, std::optional<MaterialConvention> option = {}) {
        LoadOptions options;
        options.materials = option;
        return loadScene(file, options);
    }
    LoadedScene loadText(const std::string& scene, std::optional<MaterialConvention> option = {}) {
        return load(folder_.write("a.scene", scene), option);
    }
    std::string error(const std::string& scene, std::optional<MaterialConvention> option = {}) {
        return inputError([&] { loadText(scene, option); });
    }
    /// How the only MTL file was taken, and why.
    void expectTaken(const LoadedScene& loaded, MaterialConvention convention,
                     const std::string& reason) {
        ASSERT_EQ(loaded.materialFiles.size(), 1u);
        EXPECT_EQ(loaded.materialFiles[0].convention, convention);
        EXPECT_EQ(loaded.materialFiles[0].reason, reason);
        const bool isDemo = loaded.scene.materials.at(0).reflectance == 0.5f;
        EXPECT_EQ(isDemo, convention == kDemo);
    }

    const std::string triangle_ = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    test::TemporaryFolder folder_;
};

TEST_F(Convention, OfAModelByItselfIsWavefront) {
    const LoadedScene loaded = load(folder_ / "a.obj");
    expectTaken(loaded, kWavefront, "it is of a model by itself");
    EXPECT_EQ(loaded.materialFiles[0].file, folder_ / "a.mtl");
    EXPECT_EQ(loaded.scene.microfacetModel, MicrofacetModel::ggx);
}

TEST_F(Convention, OfObjectsInSceneFilesIsTheDemos) {
    const LoadedScene loaded = loadText("<world><object file='a.obj'/></world>");
    expectTaken(loaded, kDemo, "it is of an object of a .scene file");
    EXPECT_EQ(loaded.scene.microfacetModel, MicrofacetModel::beckmann);
}

TEST_F(Convention, FollowsMetallicWhereNobodyChooses) {
    const LoadedScene loaded = load(folder_ / "metal.obj");
    expectTaken(loaded, kDemo, "it says metallic");
    EXPECT_EQ(loaded.scene.materials[0].metallic, 1.0f);
    EXPECT_EQ(loaded.scene.microfacetModel, MicrofacetModel::beckmann);
    EXPECT_TRUE(loaded.ignored.empty());
    const LoadedScene chosen = load(folder_ / "metal.obj", kWavefront);
    expectTaken(chosen, kWavefront, "--materials says so");
    EXPECT_EQ(chosen.scene.materials[0].metallic, 0.0f);
    EXPECT_EQ(chosen.ignored, std::vector<std::string>{"MTL metallic"});
    expectTaken(loadText("<world materials='wavefront'><object file='metal.obj'/></world>"),
                kWavefront, "<world> says so");
}

TEST_F(Convention, TheOptionOverridesTheObjectAndThatTheWorld) {
    const std::string world = "<world materials='wavefront'><object file='a.obj'/></world>";
    const std::string both =
        "<world materials='wavefront'><object file='a.obj' materials='demo'/></world>";
    const std::string object = "<world><object file='a.obj' materials='wavefront'/></world>";
    expectTaken(loadText(world), kWavefront, "<world> says so");
    expectTaken(loadText(both), kDemo, "its <object> says so");
    expectTaken(loadText(object), kWavefront, "its <object> says so");
    expectTaken(loadText(both, kWavefront), kWavefront, "--materials says so");
    expectTaken(loadText(world, kDemo), kDemo, "--materials says so");
    expectTaken(load(folder_ / "a.obj", kDemo), kDemo, "--materials says so");
}

TEST_F(Convention, IsThatOfEachObjectThoughFilesAreReadOnce) {
    const LoadedScene loaded =
        loadText("<world><object file='a.obj'/><object file='a.obj' materials='wavefront'/>"
                 "<object file='a.obj' materials='demo'/><object file='a.obj'/></world>");
    const Mesh& mesh = loaded.scene.mesh;
    ASSERT_EQ(mesh.materials.size(), 4u);
    const auto reflectance = [&](size_t triangle) {
        return loaded.scene.materials[mesh.materials[triangle]].reflectance;
    };
    EXPECT_EQ(reflectance(0), 0.5f);
    EXPECT_EQ(reflectance(1), 0.04f);
    EXPECT_EQ(reflectance(2), 0.5f);
    EXPECT_EQ(reflectance(3), 0.5f);
    EXPECT_EQ(loaded.scene.materials.size(), 2u);
    ASSERT_EQ(loaded.materialFiles.size(), 3u) << "one for each reason";
    EXPECT_EQ(loaded.materialFiles[1].convention, kWavefront);
}

TEST_F(Convention, RefusesWhatIsNone) {
    EXPECT_EQ(error("<world materials='phong'>\n<object file='a.obj'/></world>"),
              folder_ / "a.scene" + ":1: <world>: materials='phong' is neither demo nor wavefront");
    EXPECT_EQ(error("<world>\n<object file='a.obj' materials=''/></world>"),
              folder_ / "a.scene" + ":2: <object>: materials='' is neither demo nor wavefront");
}

TEST_F(Convention, OptionWithoutAnObjFileIsRefused) {
    const std::string gltf =
        folder_.write("a.gltf",
                      R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
        "meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
        "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],
        "bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36,"uri":
        "data:;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})");
    EXPECT_EQ(inputError([&] { load(gltf, kDemo); }),
              "--materials: has no effect without an OBJ file");
    EXPECT_EQ(inputError([&] { load(gltf); }), "");
    EXPECT_EQ(error("<world><object file='a.gltf'/><object file='a.obj'/></world>", kDemo), "");
}

/// Whatever an object is hidden by, somebody will look for it.
TEST_F(Convention, SurfacesTooTransparentToShowAreNamed) {
    folder_.write("a.mtl", "newmtl m\nKd 0 1 0\nd 0.4\nnewmtl unused\nd 0\n");
    const std::string line = folder_ / "a.mtl" + ":3: material 'm' has d 0.4: more transparent "
                                                 "than not, it is not shown at all";
    for (const auto convention : {kDemo, kWavefront}) {
        const LoadedScene loaded = load(folder_ / "a.obj", convention);
        ASSERT_EQ(loaded.warnings.size(), 1u);
        EXPECT_EQ(loaded.warnings[0].kind, WarningKind::unseenMaterial);
        EXPECT_EQ(loaded.warnings[0].text, line);
    }
    folder_.write("a.mtl", "newmtl m\nTr 0.75\n");
    const LoadedScene loaded = load(folder_ / "a.obj");
    ASSERT_EQ(loaded.warnings.size(), 1u);
    EXPECT_NE(loaded.warnings[0].text.find(":2: material 'm' has Tr 0.75"), std::string::npos);
    folder_.write("a.mtl", "newmtl m\nd 0.6\n");
    const LoadedScene opaque = load(folder_ / "a.obj");
    EXPECT_TRUE(opaque.warnings.empty());
    EXPECT_EQ(opaque.ignored, std::vector<std::string>{"MTL d from 1/2 to 1, taken as opaque"});
}

/// Files that other programs have written, and what their makers see in them.
class RealMaterials : public testing::Test {
protected:
    /// The only material that some triangle has, of a file that is taken as other programs mean it.
    Material load(const std::filesystem::path& file, size_t triangle = 0) {
        loaded_ = loadScene(file);
        EXPECT_EQ(loaded_.materialFiles.at(0).convention, kWavefront);
        return loaded_.scene.materials[loaded_.scene.mesh.materials.at(triangle)];
    }

    LoadedScene loaded_;
};

TEST_F(RealMaterials, OfMeshLabShowTheirTexture) {
    const auto folder = modelsFolder() / "trimesh";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no models at " << folder;
    const Material fuze = load(folder / "fuze.obj"); // Ks 1, Ns 0, Tr 1
    EXPECT_NE(fuze.diffuseMap, kNoTexture);
    EXPECT_EQ(fuze.reflectance, 0.08f);
    EXPECT_EQ(fuze.roughness, 1.0f);
    EXPECT_EQ(fuze.opacity, 1.0f);
    EXPECT_TRUE(loaded_.warnings.empty());
    EXPECT_EQ(load(folder / "capsule.obj").opacity, 1.0f); // Tr 1, too
    const Material box = load(folder / "box.obj");         // Blender's: Ks .5, Ns 324
    EXPECT_EQ(box.reflectance, 0.04f);
    EXPECT_NEAR(box.roughness, std::pow(1.0 - std::sqrt(0.324), 2.0), 1e-6);
}

TEST_F(RealMaterials, OfTheCornellBoxesHaveTheirMirrors) {
    const auto folder = scenesFolder() / "cornell-boxes";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no scenes at " << folder;
    load(folder / "CornellBox-Mirror.obj");
    const auto& materials = loaded_.scene.materials;
    const auto mirror = std::find_if(materials.begin(), materials.end(),
                                     [](const Material& m) { return m.name == "tallBox"; });
    ASSERT_NE(mirror, materials.end());
    EXPECT_FLOAT_EQ(mirror->reflectance, 0.95f);
    EXPECT_EQ(mirror->roughness, 0.0f);
    EXPECT_EQ(std::count_if(materials.begin(), materials.end(),
                            [](const Material& m) { return m.reflectance > 0.0f; }),
              1);
}

} // namespace
} // namespace dirt
