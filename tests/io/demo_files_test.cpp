// The scene and material files of the 2017 demo, as they are. Its models are not there; a triangle
// for each material stands in.

#include "backend_cpu/cpu_backend.h"
#include "backend_cpu/thread_pool.h"
#include "core/frame/renderer.h"
#include "core/io/load.h"
#include "core/io/mtl.h"
#include "tests/io/input_error.h"
#include "tests/io/test_scenes.h"
#include "tests/support/small_scenes.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <pugixml.hpp>

namespace dirt {
namespace {

namespace fs = std::filesystem;

/// The demo's files that end in \p extension, below its folder.
std::vector<fs::path> demoFiles(const std::string& extension) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(demoFolder()))
        if (entry.path().extension() == extension) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

class DemoFiles : public testing::Test {
protected:
    void SetUp() override {
        if (!fs::is_directory(demoFolder()))
            GTEST_SKIP() << "no files of the 2017 demo at " << demoFolder();
    }

    /// Calls \p visit(element, attribute) for every attribute of a scene file.
    template <typename Visit>
    static void forEachAttribute(pugi::xml_node node, Visit&& visit) {
        for (pugi::xml_attribute attribute : node.attributes()) visit(node, attribute);
        for (pugi::xml_node child : node.children()) forEachAttribute(child, visit);
    }

    static bool isHonoured(pugi::xml_node node, pugi::xml_attribute attribute) {
        const auto all = honouredSceneAttributes();
        return std::any_of(all.begin(), all.end(), [&](const SceneAttribute& honoured) {
            return honoured.element == node.name() && honoured.attribute == attribute.name();
        });
    }

    test::TemporaryFolder folder_;
};

TEST_F(DemoFiles, AreReadAsTheyAre) {
    const auto files = demoFiles(".scene");
    EXPECT_EQ(files.size(), 17u);
    for (const fs::path& file : files) {
        SCOPED_TRACE(file);
        LoadReport report;
        const SceneFile scene = readSceneFile(file, report);
        const std::string name = file.stem().string();
        EXPECT_TRUE(scene.hasCamera);
        EXPECT_TRUE(scene.light);
        EXPECT_EQ(scene.settings.bounces, 2);
        EXPECT_EQ(scene.settings.view,
                  name.find("full") != std::string::npos ? ViewMode::full : ViewMode::single);
        EXPECT_TRUE(scene.settings.tile && *scene.settings.tile <= 8);
        const size_t objects = name[0] == 'b' ? 11 : name[0] == 'h' ? 3 : 1;
        EXPECT_EQ(scene.objects.size(), name.rfind("template", 0) == 0 ? 0 : objects);
    }
}

TEST_F(DemoFiles, HaveNoAttributeThatIsNeitherHonouredNorNamedOnce) {
    for (const fs::path& file : demoFiles(".scene")) {
        SCOPED_TRACE(file);
        LoadReport report;
        readSceneFile(file, report);
        const auto& ignored = report.ignored();
        pugi::xml_document document;
        ASSERT_TRUE(document.load_file(file.c_str()));
        forEachAttribute(document.document_element(), [&](auto node, auto attribute) {
            if (std::string(attribute.name()) == "name" || isHonoured(node, attribute)) return;
            const std::string element = node.name();
            const bool named =
                std::count(ignored.begin(), ignored.end(),
                           "attribute " + std::string(attribute.name()) + " of <" + element +
                               ">") == 1 ||
                std::count(ignored.begin(), ignored.end(),
                           "element <" + element + "> in <" + node.parent().name() + ">") == 1;
            EXPECT_TRUE(named) << attribute.name() << " of " << element;
        });
    }
}

TEST_F(DemoFiles, AttributesThatAreNamedAsIgnoredAreNotRead) {
    for (const fs::path& file : demoFiles(".scene")) {
        pugi::xml_document document;
        ASSERT_TRUE(document.load_file(file.c_str()));
        forEachAttribute(document.document_element(), [](auto node, auto attribute) {
            if (!isHonoured(node, attribute)) attribute.set_value("?");
        });
        ASSERT_TRUE(document.save_file((folder_ / "a.scene").c_str()));
        LoadReport report;
        EXPECT_EQ(inputError([&] { readSceneFile(folder_ / "a.scene", report); }), "") << file;
    }
}

/// The demo's files beside stand-ins for its models.
class DemoScenes : public DemoFiles {
protected:
    void SetUp() override {
        DemoFiles::SetUp();
        if (IsSkipped()) return;
        test::Random random(1);
        for (const fs::path& file : demoFiles(".mtl")) {
            const auto materials = readMtl(file).materials;
            EXPECT_FALSE(materials.empty()) << file;
            std::string obj = "mtllib " + file.filename().string() + "\n";
            for (const MtlMaterial& material : materials)
                obj += "usemtl " + material.name + "\n" +
                       faces(random, reachOf(file.parent_path().filename()));
            const fs::path target = file.lexically_relative(demoFolder());
            folder_.write(target.string(), test::readFile(file));
            folder_.write((target.parent_path() / target.stem()).string() + ".OBJ", obj);
        }
    }

    static constexpr size_t kFaces = 8; ///< of each material

    /// How far the models of a folder go, about.
    static double reachOf(const fs::path& folder) {
        return folder == "Bunny" ? 150.0 : folder == "Temples" ? 120.0 : 25.0;
    }

    /// Triangles anywhere around the origin.
    static std::string faces(test::Random& random, double reach) {
        std::string text;
        for (size_t i = 0; i < kFaces; ++i) {
            const glm::vec3 centre = test::uniformPoint(random, reach);
            for (int corner = 0; corner < 3; ++corner) {
                const glm::vec3 p = centre + test::uniformPoint(random, 0.3 * reach);
                text += "v " + std::to_string(p.x) + " " + std::to_string(p.y) + " " +
                        std::to_string(p.z) + "\n";
            }
            text += "f -3 -2 -1\n";
        }
        return text;
    }

    /// Copies a scene file beside the stand-ins. Where the templates ask for objects, one is put.
    std::string copy(const fs::path& file) {
        std::string text = test::readFile(file);
        std::erase(text, '\r');
        if (isTemplate(file)) {
            const size_t at = text.find("<!-- \n\tModify user parameters");
            EXPECT_NE(at, text.npos) << file;
            text.insert(at, "<transformation scale='0.01 0.01 0.01'><object "
                            "file='Bunny/mobilo.obj'/></transformation>\n");
        }
        return folder_.write(file.filename().string(), text);
    }

    static bool isTemplate(const fs::path& file) {
        return file.filename().string().rfind("template", 0) == 0;
    }
};

/// The files name folders and models in other letter case than they have: bunny for Bunny.
TEST_F(DemoScenes, LoadWithEveryMaterial) {
    for (const fs::path& file : demoFiles(".scene")) {
        SCOPED_TRACE(file);
        if (isTemplate(file)) {
            const std::string bare = folder_.write("bare.scene", test::readFile(file));
            EXPECT_EQ(inputError([&] { loadScene(bare); }), bare + ": holds no triangles");
        }
        const LoadedScene loaded = loadScene(copy(file));
        EXPECT_GT(loaded.scene.mesh.triangles.size(), 0u);
        EXPECT_EQ(loaded.scene.materials.size() * kFaces, loaded.scene.mesh.triangles.size());
        for (const Warning& warning : loaded.warnings)
            EXPECT_EQ(warning.kind, WarningKind::unusableTexture) << warning.text;
    }
}

/// With the files' own settings, but for the size of the image.
TEST_F(DemoScenes, RenderAsTheyAre) {
    ThreadPool pool(2);
    CpuBackend backend(pool);
    for (const fs::path& file : demoFiles(".scene")) {
        SCOPED_TRACE(file);
        const LoadedScene loaded = loadScene(copy(file));
        EXPECT_EQ(loaded.settings.visibility, LightVisibility::shadowMap);
        RenderSettings settings;
        settings.grid.width = 24;
        settings.grid.height = 16;
        settings.samples = 1;
        settings.grid.mode = *loaded.settings.view;
        settings.grid.tile = *loaded.settings.tile;
        settings.grid.bins = *loaded.settings.bins;
        settings.bounces = *loaded.settings.bounces;
        settings.visibility = *loaded.settings.visibility;
        const RenderResult result = Renderer(loaded.scene, settings, backend).render();
        EXPECT_EQ(result.samples, 1);
        const size_t side = (size_t) loaded.scene.lights.front().resolution;
        EXPECT_EQ(backend.readShadowMap().size(), side * side);
        size_t lit = 0;
        for (const glm::vec3& pixel : result.image.pixels) {
            for (int c = 0; c < 3; ++c) ASSERT_TRUE(std::isfinite(pixel[c]) && pixel[c] >= 0.0f);
            lit += pixel != glm::vec3(0.0f);
        }
        EXPECT_GE(lit, 5u);
        EXPECT_GE(result.counts.hits, 5u);
    }
}

TEST_F(DemoFiles, HangarIsWhatItsTextSays) {
    LoadReport report;
    const SceneFile scene = readSceneFile(demoFolder() / "hangar_dirt_full.scene", report);
    EXPECT_EQ(scene.directories, std::vector<std::string>{"Hangar"});
    EXPECT_EQ(scene.camera.verticalFov, 60.0f);
    EXPECT_EQ(scene.camera.eye, glm::vec3(-8.73f, 4.57f, 8.24f));
    EXPECT_EQ(scene.camera.target, glm::vec3(-0.93f, -0.84f, 28.31f));
    EXPECT_EQ(scene.light->flux, 3000.0f);
    EXPECT_EQ(scene.light->penumbra, 20.0f);
    EXPECT_EQ(scene.settings.bins, 20);
    EXPECT_EQ(scene.toneMapping.white, 2.0f);
    EXPECT_EQ(scene.objects[2].file, "dreadnaught.obj");
    EXPECT_EQ(scene.objects[2].line, 37u);
    EXPECT_EQ(scene.objects[2].toSpace[3], glm::dvec4(3, 0, 26, 1));
}

} // namespace
} // namespace dirt
