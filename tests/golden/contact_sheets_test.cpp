// What the program makes of models without being told how to look at them: the automatic camera,
// light and background, on sheets that somebody has looked at. The made models are always there;
// those of $DIRT_MODELS and $DIRT_SCENES, which the project does not contain, where they are given.

#include "core/io/image.h"
#include "tests/cli/program.h"
#include "tests/io/test_scenes.h"
#include "tests/support/golden_picture.h"
#include "tests/support/made_models.h"

#include <cmath>
#include <sstream>

namespace dirt::test {
namespace {

namespace fs = std::filesystem;

constexpr int kWidth = 128, kHeight = 96, kColumns = 6;

class Sheet {
public:
    /// Adds what `dirt render` makes of a model.
    void add(const fs::path& model) {
        SCOPED_TRACE(model);
        const std::string picture = folder_ / "picture.png";
        const Outcome run = dirt({"render", model, "--no-cache", "--size",
                                  std::to_string(kWidth) + "x" + std::to_string(kHeight), "--spp",
                                  "4", "--bounces", "2", "-o", picture});
        ASSERT_EQ(run.status, 0) << run.err;
        pictures_.push_back(readImage(picture));
        fs::remove(picture);
    }

    void expectAsItWas(const std::string& name) const {
        const int rows = ((int) pictures_.size() + kColumns - 1) / kColumns;
        const size_t width = (size_t) kColumns * kWidth, height = (size_t) rows * kHeight;
        std::vector<uint8_t> rgb(3 * width * height, 0);
        for (size_t i = 0; i < pictures_.size(); ++i)
            for (size_t y = 0; y < (size_t) kHeight; ++y)
                for (size_t x = 0; x < (size_t) kWidth; ++x) {
                    const size_t left = i % kColumns * kWidth, top = i / kColumns * kHeight;
                    const glm::vec3 pixel = pictures_[i].pixels[y * kWidth + x];
                    for (int c = 0; c < 3; ++c)
                        rgb[3 * ((top + y) * width + left + x) + (size_t) c] =
                            (uint8_t) std::lround(255.0f * pixel[c]);
                }
        expectGolden(name, (int) width, (int) height, rgb);
    }

private:
    TemporaryFolder folder_;
    std::vector<Image> pictures_;
};

std::string objOf(const Mesh& mesh) {
    std::ostringstream text;
    text.precision(9);
    for (const glm::vec3& p : mesh.positions)
        text << "v " << p.x << ' ' << p.y << ' ' << p.z << '\n';
    for (const Corners& t : mesh.triangles)
        text << "f " << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1 << '\n';
    return text.str();
}

TEST(ContactSheets, MadeModels) {
    const TemporaryFolder folder;
    Sheet sheet;
    for (const auto& models : {objects(), rooms()})
        for (const auto& [name, mesh] : models) sheet.add(folder.write("model.obj", objOf(mesh)));
    sheet.expectAsItWas("sheet_made");
}

void expectFiles(const fs::path& folder, std::initializer_list<const char*> files,
                 const std::string& name) {
    Sheet sheet;
    for (const char* file : files) {
        if (!fs::exists(folder / file)) GTEST_SKIP() << "no " << folder / file;
        sheet.add(folder / file);
    }
    sheet.expectAsItWas(name);
}

TEST(ContactSheets, OtherProgramsModels) {
    expectFiles(
        modelsFolder(),
        {"Cameras/Cameras.gltf", "CesiumMilkTruck/CesiumMilkTruck.gltf",
         "BoxTextured/BoxTextured.gltf", "TwoSidedPlane/TwoSidedPlane.gltf",
         "BoxVertexColors/BoxVertexColors.gltf", "TextureCoordinateTest/TextureCoordinateTest.gltf",
         "TextureSettingsTest/TextureSettingsTest.gltf", "trimesh/fuze.obj", "trimesh/box.obj",
         "trimesh/capsule.obj", "trimesh/chair_model.obj", "trimesh/fandisk.obj"},
        "sheet_models");
}

TEST(ContactSheets, RealScenes) {
    expectFiles(scenesFolder(),
                {"crytek-sponza/sponza.obj",
                 "conference/conference.obj",
                 "cornell-boxes/CornellBox-Original.obj",
                 "cornell-boxes/CornellBox-Glossy.obj",
                 "cornell-boxes/CornellBox-Glossy-Floor.obj",
                 "cornell-boxes/CornellBox-Mirror.obj",
                 "cornell-boxes/CornellBox-Sphere.obj",
                 "cornell-boxes/CornellBox-Water.obj",
                 "cornell-boxes/CornellBox-Empty-CO.obj",
                 "cornell-boxes/CornellBox-Empty-RG.obj",
                 "cornell-boxes/CornellBox-Empty-Squashed.obj",
                 "cornell-boxes/CornellBox-Empty-White.obj",
                 "sterngarten/Sterngarten_Wien_innerArea-optimized.obj",
                 "forza/forza.obj",
                 "bunny/bunny.obj",
                 "japaneseMaple/japaneseMaple.obj",
                 "bush/bush.obj",
                 "assimp/2CylinderEngine.glb",
                 "vianney_house_2/scene.gltf",
                 "assimp/OBJ/spider.obj",
                 "assimp/OBJ/WusonOBJ.obj",
                 "assimp/OBJ/concave_polygon.obj",
                 "assimp/OBJ/cube_with_vertexcolors.obj",
                 "assimp/OBJ/box_mat_with_spaces.obj"},
                "sheet_scenes");
}

} // namespace
} // namespace dirt::test
