// Cameras and lights of glTF files, as options and `dirt info` have them.

#include "tests/cli/program.h"
#include "tests/io/gltf_writer.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace dirt::test {
namespace {

/// A triangle, and two cameras on the Z axis.
GltfWriter filmed() {
    GltfWriter writer;
    writer.triangle();
    const Json perspective = {{"type", "perspective"}, {"perspective", {{"yfov", 0.5}}}};
    writer.json["cameras"] = Json::array({perspective, perspective});
    writer.node({{"camera", 0}, {"translation", {0.25, 0.25, 20}}, {"name", "front"}});
    writer.node({{"camera", 1}, {"translation", {0.25, 0.25, 5}}, {"name", "near"}});
    return writer;
}

nlohmann::json infoOf(const std::string& file, std::vector<std::string> options = {}) {
    options.insert(options.begin(), {"info", "--json", file});
    const Outcome run = dirt(options);
    EXPECT_EQ(run.status, 0) << run.err;
    return nlohmann::json::parse(run.out);
}

TEST(ModelCamera, TheFirstByDefaultAndAnyByNumberOrName) {
    const TemporaryFolder folder;
    const std::string file = folder.write("a.gltf", filmed().embedded());
    using Json = nlohmann::json;
    const Json first = infoOf(file);
    EXPECT_EQ(first["camera"]["eye"], Json({0.25, 0.25, 20.0}));
    ASSERT_EQ(first["cameras"].size(), 2u);
    EXPECT_EQ(first["cameras"][0],
              Json({{"name", "front"}, {"perspective", true}, {"used", true}}));
    EXPECT_EQ(first["cameras"][1]["used"], false);
    EXPECT_EQ(first["lights"], 1) << "beside the camera";
    for (const char* wanted : {"1", "near"})
        EXPECT_EQ(infoOf(file, {"--camera", wanted})["camera"]["eye"], Json({0.25, 0.25, 5.0}));
    // Whoever says where to stand means it.
    EXPECT_EQ(infoOf(file, {"--eye=0,0,2", "--target=0,0,0"})["camera"]["eye"],
              Json({0.0, 0.0, 2.0}));
    // A scene file's user counts, but for the option.
    const std::string scene = folder.write(
        "a.scene", "<world><user position='0 0 3' lookat='0 0 0'/><object file='a.gltf'/></world>");
    EXPECT_EQ(infoOf(scene)["camera"]["eye"], Json({0.0, 0.0, 3.0}));
    EXPECT_EQ(infoOf(scene, {"--camera", "0"})["camera"]["eye"], Json({0.25, 0.25, 20.0}));
}

TEST(ModelCamera, WhatIsNotThereIsSaidInOneLine) {
    const TemporaryFolder folder;
    const std::string file = folder.write("a.gltf", filmed().embedded());
    const auto error = [&](std::vector<std::string> options) {
        options.insert(options.begin(), {"info", "--json"});
        const Outcome run = dirt(options);
        EXPECT_EQ(run.status, 2);
        return run.err;
    };
    EXPECT_EQ(error({file, "--camera", "2"}),
              "dirt: --camera '2': there is none; it has 0 'front', 1 'near'\n");
    EXPECT_EQ(error({folder.write("a.obj", kTriangleObj), "--camera", "0"}),
              "dirt: --camera '0': the scene's files have none\n");
    EXPECT_EQ(error({file, "--camera", "0", "--eye=0,0,1"}),
              "dirt: --camera says where to stand, and so do --eye and --target\n");
}

} // namespace
} // namespace dirt::test
