// Blender, where it is installed, has a pass for each of a dump's numbers and
// vectors, and for each layer beside a render.

#include "tests/cli/program.h"

#include <sstream>

#include <gtest/gtest.h>

namespace dirt::test {
namespace {

const std::string kSource = DIRT_SOURCE_DIR;

Outcome blender(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "blender");
    return start("/usr/bin/env", arguments);
}

/// Of each file, or FILE:LAYER, the line that says its passes.
std::vector<std::string> passesOf(const std::vector<std::string>& files) {
    std::vector<std::string> arguments = {
        "-b", "-noaudio", "--factory-startup", "--python", kSource + "/tests/cli/blender_passes.py",
        "--"};
    arguments.insert(arguments.end(), files.begin(), files.end());
    std::istringstream out(blender(arguments).out);
    std::vector<std::string> lines;
    for (std::string line; std::getline(out, line);)
        if (line.starts_with("PASSES ")) lines.push_back(line.substr(7));
    return lines;
}

class Blender : public testing::Test {
protected:
    TemporaryFolder folder_;
    const std::string scene_ = kSource + "/scenes/cornell.scene";

    void SetUp() override {
        if (blender({"--version"}).status != 0) GTEST_SKIP() << "there is no blender on the PATH";
    }
};

TEST_F(Blender, HasAPassForEachNumberOfADump) {
    const std::string to = folder_ / "dump";
    ASSERT_EQ(dirt({"dump", scene_, "--quiet", "--size", "32x24", "--primary", "traced", "-o", to})
                  .status,
              0);
    const std::string point =
        " diffuse/RGBA emission/RGBA geometricNormal/RGBA gloss/VALUE position/RGBA "
        "primitive/VALUE roughness/VALUE shadingNormal/RGBA u/VALUE v/VALUE";
    EXPECT_EQ(
        passesOf({to + "/direct.exr", to + "/shading.1.exr:previous", to + "/shading.1.exr:next",
                  to + "/rays.1.exr", to + "/hits.1.exr", to + "/shadowrays.1.exr",
                  to + "/mask.1.exr", to + "/visibility.0.exr", to + "/triangles.exr"}),
        (std::vector<std::string>{
            "-" + point, "previous" + point, "next" + point,
            "- direction/RGBA origin/RGBA pdf/VALUE skip/VALUE throughput/RGBA",
            "- fetches/VALUE primitive/VALUE t/VALUE tile/VALUE u/VALUE v/VALUE view/VALUE",
            "- blocker/VALUE column/VALUE direction/RGBA occluded/VALUE origin/RGBA "
            "row/VALUE skip/VALUE t/VALUE tMax/VALUE view/VALUE",
            "- alive/VALUE", "- visible/VALUE", "- a/RGBA b/RGBA c/RGBA"}));
}

TEST_F(Blender, HasAPassForEachLayerOfARender) {
    const std::string to = folder_ / "a.exr";
    ASSERT_EQ(dirt({"render", scene_, "--quiet", "--size", "32x24", "--spp", "2", "--aov",
                    "albedo,emission,normal,geometricNormal,roughness,depth,position,id,variance",
                    "-o", to})
                  .status,
              0);
    EXPECT_EQ(passesOf({to}),
              (std::vector<std::string>{
                  "- Alpha/VALUE Combined/RGBA albedo/RGBA depth/VALUE emission/RGBA "
                  "geometricNormal/RGBA id/VALUE normal/RGBA position/RGBA roughness/VALUE "
                  "variance/RGBA"}));
}

} // namespace
} // namespace dirt::test
