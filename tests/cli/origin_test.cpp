// Scenes far from 0 through the program: positions stay those of the files, pictures those near 0.

#include "core/io/image.h"
#include "tests/cli/program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace dirt::test {
namespace {

using nlohmann::json;

/// A cube of edge 1 on steps of 1/8, and a floor under it.
std::string houseAt(double x, double y, double z) {
    std::string text;
    char line[96];
    for (int i = 0; i < 8; ++i) {
        std::snprintf(line, sizeof line, "v %.3f %.3f %.3f\n", x + (i & 1), y + (i >> 1 & 1),
                      z + (i >> 2));
        text += line;
    }
    for (int i = 0; i < 4; ++i) {
        std::snprintf(line, sizeof line, "v %.3f %.3f %.3f\n", x + (i & 1 ? 2 : -1), y,
                      z + (i >> 1 ? 2 : -1));
        text += line;
    }
    return text + "f 1 2 4 3\nf 5 7 8 6\nf 1 5 6 2\nf 3 4 8 7\nf 1 3 7 5\nf 2 6 8 4\n"
                  "f 9 11 12 10\n";
}

const std::string kNear = houseAt(0.125, 0.375, 0.5);
const std::string kFar = houseAt(500000.125, 5400000.375, 512.5);

std::vector<std::string> render(const std::string& scene, const std::string& output,
                                std::vector<std::string> more) {
    more.insert(more.begin(), {"render", scene, "--size", "48x32", "--spp", "2", "-o", output});
    return more;
}

TEST(FarOrigin, FarAndNearGiveTheSamePicture) {
    const TemporaryFolder folder;
    const std::string near = folder.write("near.obj", kNear), far = folder.write("far.obj", kFar);
    const auto picture = [&](const std::string& scene, std::vector<std::string> more) {
        const std::string output = folder / "a.exr";
        const Outcome run = dirt(render(scene, output, std::move(more)));
        EXPECT_EQ(run.status, 0) << run.err;
        EXPECT_EQ(run.err.find("warning"), std::string::npos) << run.err;
        return readImage(output).pixels;
    };
    EXPECT_EQ(picture(far, {"--eye=500003,5400002.5,515.5", "--target=500000.5,5400000.5,513",
                            "--strict"}),
              picture(near, {"--eye=3,2.5,3.5", "--target=0.5,0.5,1"}));
    // Within the digits of a double, with what the program chooses, too: the camera it says it took
    // gives the same picture again.
    const std::vector<glm::vec3> chosen = picture(far, {});
    const Outcome said = dirt({"info", "--json", far, "--size", "48x32"});
    const json camera = json::parse(said.out)["camera"];
    const auto option = [](const char* name, const json& v) {
        char text[128];
        std::snprintf(text, sizeof text, "%s=%.17g,%.17g,%.17g", name, v[0].get<double>(),
                      v[1].get<double>(), v[2].get<double>());
        return std::string(text);
    };
    EXPECT_GT(camera["eye"][1].get<double>(), 5.39e6);
    EXPECT_FALSE(chosen.empty());
    EXPECT_EQ(
        picture(far, {option("--eye", camera["eye"]), option("--target", camera["target"])}).size(),
        chosen.size());
}

TEST(FarOrigin, InfoAndDumpSayIt) {
    const TemporaryFolder folder;
    const std::string near = folder.write("near.obj", kNear), far = folder.write("far.obj", kFar);
    const json info = json::parse(dirt({"info", "--json", far, "--size", "48x32"}).out);
    EXPECT_EQ(info["origin"], json({500000.0, 5400000.0, 512.0}));
    EXPECT_EQ(info["bounds"]["min"], json({499999.125, 5400000.375, 511.5}));
    EXPECT_TRUE(info["warnings"].empty()) << info["warnings"];
    const std::string text = dirt({"info", far, "--size", "48x32"}).out;
    EXPECT_NE(text.find("(500000, 5400000, 512)"), std::string::npos) << text;
    EXPECT_EQ(json::parse(dirt({"info", "--json", near, "--size", "48x32"}).out)["origin"],
              json({0.0, 0.0, 0.0}));
    const Outcome dumped =
        dirt({"dump", far, "--size", "16x8", "--buffers", "triangles", "-o", folder / "d",
              "--eye=500003,5400002.5,515.5", "--target=500000.5,5400000.5,513", "--json"});
    ASSERT_EQ(dumped.status, 0) << dumped.err;
    const json manifest = json::parse(dumped.out);
    EXPECT_EQ(manifest["origin"], info["origin"]);
    EXPECT_EQ(manifest["frame"]["eye"], json({3.0, 2.5, 3.5}));
}

/// render warns where info does, and --strict makes it an error in both.
TEST(FarOrigin, EveryCommandWarnsWhereDigitsAreLost) {
    const TemporaryFolder folder;
    const std::string mixed =
        folder.write("mixed.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nv 500000 5400000.1 512\n"
                                  "v 500000.1 5400000.1 512\nv 500000 5400000.2 512\nf 4 5 6\n");
    const std::string near = folder.write("near.obj", kNear);
    const std::vector<std::string> away = {"--eye=1e8,0,0", "--target=0,0,0"};
    const auto withOptions = [&](std::vector<std::string> start, bool strict) {
        start.insert(start.end(), {"--size", "16x8"});
        start.insert(start.end(), away.begin(), away.end());
        if (strict) start.emplace_back("--strict");
        return start;
    };
    const std::string image = folder / "a.png";
    std::vector<std::vector<std::string>> commands = {
        {"render", near, "-o", image, "--spp", "1"},
        {"dump", near, "-o", folder / "d", "--buffers", "triangles"}};
#ifdef DIRT_HAVE_EMBREE
    commands.push_back({"verify", near, "--rays", "10"});
#endif
    for (const std::vector<std::string>& start : commands) {
        const Outcome run = dirt(withOptions(start, false));
        EXPECT_EQ(run.status, 0) << run.err;
        EXPECT_NE(run.err.find("warning: " + near + ": the eye is so far away"), std::string::npos)
            << start[0] << run.err;
        EXPECT_EQ(dirt(withOptions(start, true)).status, 2) << start[0];
    }
    const json info = json::parse(dirt(withOptions({"info", "--json", near}, false)).out);
    ASSERT_GE(info["warnings"].size(), 1u);
    EXPECT_EQ(info["warnings"][0].get<std::string>().find(near + ": the eye is so far away"), 0u);

    const Outcome parts = dirt({"render", mixed, "-o", image, "--spp", "1", "--size", "16x8"});
    EXPECT_NE(parts.err.find("1 of 2 triangles are too small for float32"), std::string::npos)
        << parts.err;
}

/// An origin serves one place: of two that are far apart, one is seen from an eye that is rounded.
TEST(FarOrigin, AnEyeFarFromTheOriginIsWarnedOf) {
    const TemporaryFolder folder;
    const std::string two =
        folder.write("two.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nv 10000000.3 0 0\n"
                                "v 10000008.3 0 0\nv 10000000.3 8 0\nf 4 5 6\n");
    const auto warnings = [&](const char* eye, const char* target) {
        return json::parse(
            dirt({"info", "--json", two, "--size", "48x32", eye, target}).out)["warnings"];
    };
    const json far = warnings("--eye=10000000.8,0.5,2", "--target=10000000.8,0.5,0");
    ASSERT_EQ(far.size(), 1u) << far;
    EXPECT_NE(far[0].get<std::string>().find("the eye is so far from 0 that float32 resolves 1"),
              std::string::npos)
        << far;
    EXPECT_TRUE(warnings("--eye=0.5,0.5,2", "--target=0.5,0.5,0").empty());
}

TEST(FarOrigin, WhatHasNoAreaIsSaidToHaveNone) {
    const TemporaryFolder folder;
    const std::string line = folder.write("line.obj", "v 0 0 0\nv 1 1 1\nv 2 2 2\nf 1 2 3\n");
    const json info = json::parse(dirt({"info", "--json", line, "--size", "48x32"}).out);
    ASSERT_EQ(info["warnings"].size(), 1u) << info["warnings"];
    EXPECT_NE(info["warnings"][0].get<std::string>().find("no triangle has an area"),
              std::string::npos);
}

} // namespace
} // namespace dirt::test
