// `dirt info`: what it says of a scene, and that options override the file, which overrides the
// defaults.

#include "tests/cli/program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace dirt::test {
namespace {

using nlohmann::json;

json info(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"info", "--json"});
    const Outcome run = dirt(arguments);
    EXPECT_EQ(run.status, 0) << run.err;
    return json::parse(run.out);
}

std::string sceneWith(const TemporaryFolder& folder, const std::string& tracing) {
    folder.write("a.obj", kTriangleObj);
    return folder.write("a.scene", "<world>" + tracing +
                                       "<object file=\"a.obj\"/>"
                                       "<user position=\"0 0 0\" lookat=\"0 0 -1\"/></world>");
}

TEST(Info, CountsWhatTheSceneHolds) {
    const TemporaryFolder folder;
    folder.write("m.mtl", "newmtl lamp\nKe 1 1 1\nnewmtl wall\nmap_Kd none.png\n");
    const json got =
        info({folder.write("two.obj", "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 -3\n"
                                      "usemtl lamp\nf 1 2 3\nusemtl wall\nf 1 2 4\n")});
    EXPECT_EQ(got["scene"], "two");
    EXPECT_EQ(got["triangles"], 2);
    EXPECT_EQ(got["emissive_triangles"], 1);
    EXPECT_EQ(got["textures"]["found"], 0);
    EXPECT_EQ(got["textures"]["named"], 1);
    EXPECT_EQ(got["warnings"].size(), 1u);
    EXPECT_EQ(got["bounds"]["min"], json({0.0, 0.0, -3.0}));
    EXPECT_EQ(got["bounds"]["max"], json({1.0, 2.0, 0.0}));
}

TEST(Info, DefaultsHoldWhereNothingIsSaid) {
    const TemporaryFolder folder;
    const json got = info({sceneWith(folder, "")});
    EXPECT_EQ(got["backend"], "cpu");
    EXPECT_EQ(got["size"], json({1024, 512}));
    EXPECT_EQ(got["view"], "full");
    EXPECT_EQ(got["views"], 6);
    EXPECT_EQ(got["cost_model"]["tile_chosen"], true);
    EXPECT_EQ(got["cost_model"]["bins_chosen"], true);
    EXPECT_EQ(got["spp"], 16);
    EXPECT_EQ(got["bounces"], 3);
    EXPECT_EQ(got["seed"], 0);
}

TEST(Info, TheFileOverridesDefaultsAndOptionsOverrideTheFile) {
    const TemporaryFolder folder;
    const std::string scene = sceneWith(folder, "<tracing block_size=\"4\" buckets=\"8\" "
                                                "indirect_bounces=\"4\" faces=\"single\"/>");
    const json file = info({scene});
    EXPECT_EQ(file["tile"], 4);
    EXPECT_EQ(file["bins"], 8);
    EXPECT_EQ(file["bounces"], 5);
    EXPECT_EQ(file["view"], "single");
    EXPECT_EQ(file["views"], 1);

    const json options =
        info({scene,        "--tile",    "32",     "--bins", "5",     "--bounces", "2",
              "--view",     "full",      "--size", "64x33",  "--spp", "7",         "--seed",
              "4294967295", "--threads", "1",      "--eye",  "0,0,1", "--fov",     "30"});
    EXPECT_EQ(options["tile"], 32);
    EXPECT_EQ(options["bins"], 5);
    EXPECT_EQ(options["bounces"], 2);
    EXPECT_EQ(options["view"], "full");
    EXPECT_EQ(options["size"], json({64, 33}));
    EXPECT_EQ(options["spp"], 7);
    EXPECT_EQ(options["seed"], 4294967295u);
    EXPECT_EQ(options["threads"], 1);
    EXPECT_EQ(options["camera"]["eye"], json({0.0, 0.0, 1.0}));
    EXPECT_EQ(options["camera"]["fov"], 30.0);
}

TEST(Info, PredictsWhatARenderThenNeeds) {
    const TemporaryFolder folder;
    const std::string scene = sceneWith(folder, "<tracing indirect_bounces=\"2\"/>");
    const std::string stats = (folder.path() / "stats.json").string();
    const json predicted =
        info({scene, "--size", "128x64", "--tile", "4", "--spp", "2"})["predicted"];
    ASSERT_EQ(dirt({"render", scene, "--size", "128x64", "--tile", "4", "--spp", "2", "-o",
                    (folder.path() / "a.png").string(), "--stats", stats})
                  .status,
              0);
    const json rendered = json::parse(readFile(stats));
    EXPECT_EQ(predicted["memory"], rendered["memory"]["total"]);
    EXPECT_NEAR(predicted["rays"].get<double>() / rendered["rays"].get<double>(), 1.0, 0.25);
    EXPECT_NEAR(predicted["list_entries"].get<double>() / rendered["list_entries"].get<double>(),
                1.0, 0.25);
    EXPECT_EQ(predicted["frame_ms"].get<double>(),
              predicted["build_ms"].get<double>() + 2 * predicted["sample_ms"].get<double>());
}

TEST(Info, MemoryIsTheSumOfItsBuffers) {
    const TemporaryFolder folder;
    const json memory = info({sceneWith(folder, "")})["memory"];
    uint64_t sum = 0;
    for (const auto& [name, bytes] : memory.items())
        if (name != "total") sum += bytes.get<uint64_t>();
    EXPECT_GT(sum, 0u);
    EXPECT_EQ(memory["total"], sum);
}

/// What is shown is what decides.
TEST(Info, ShowsTheBudgetThatAFrameHasToMeet) {
    const TemporaryFolder folder;
    const std::string scene = sceneWith(folder, "");
    const json budget = info({scene, "--memory", "2G"})["memory_budget"];
    EXPECT_EQ(budget["limit"], 2'000'000'000u);
    const auto needed = budget["scene"].get<uint64_t>() + budget["frame"].get<uint64_t>();
    EXPECT_GT(budget["scene"], 0u);
    EXPECT_EQ(info({scene, "--memory", std::to_string(needed)})["memory_budget"]["limit"], needed);
    const Outcome less = dirt({"info", scene, "--memory", std::to_string(needed - 1)});
    EXPECT_EQ(less.status, 2);
    EXPECT_NE(less.err.find("a frame needs about "), std::string::npos) << less.err;

    const std::string text = dirt({"info", scene, "--memory", "2G"}).out;
    const auto row = text.find("of a budget of");
    ASSERT_NE(row, std::string::npos) << text;
    EXPECT_NE(text.find("2000.00 MB, of which the scene takes ", row), std::string::npos) << text;
    EXPECT_NE(text.find(" and a frame about ", row), std::string::npos) << text;
}

TEST(Info, BuffersAreThoseOfARender) {
    const TemporaryFolder folder;
    const std::string light =
        "<light type=\"spotlight\" position=\"0 1 0\" target=\"0 0 -2\" flux=\"5\"/>";
    for (const std::string& scene : {std::string(), light})
        for (const char* bounces : {"1", "2"})
            for (const char* primary : {"raster", "traced"}) {
                const std::vector<std::string> options = {sceneWith(folder, scene),
                                                          "--size",
                                                          "20x10",
                                                          "--bounces",
                                                          bounces,
                                                          "--primary",
                                                          primary,
                                                          "--spp",
                                                          "1"};
                std::vector<std::string> render = {"render", "--quiet", "--json", "-o",
                                                   folder / "a.exr"};
                render.insert(render.end(), options.begin(), options.end());
                const json memory = json::parse(dirt(render).out)["memory"];
                size_t buffers = 0;
                const json rows = info(options)["buffers"];
                for (const json& row : rows) {
                    EXPECT_EQ(memory[row["name"].get<std::string>()], row["bytes"]) << row;
                    EXPECT_FALSE(row["reason"].get<std::string>().empty());
                    ++buffers;
                }
                EXPECT_EQ(memory.size(), buffers + 1) << memory; // and their total
            }
}

TEST(Info, SaysWhatASceneRequires) {
    const TemporaryFolder folder;
    const json plain = info({sceneWith(folder, ""), "--bounces", "1"})["requirements"];
    for (const auto& [name, row] : plain.items()) EXPECT_FALSE(row["required"]) << name;
    const json lit = info({sceneWith(
        folder, "<light type=\"spotlight\" position=\"0 1 0\" target=\"0 0 -2\" flux=\"5\"/>")});
    EXPECT_TRUE(lit["requirements"]["light"]["required"]);
    EXPECT_TRUE(lit["requirements"]["indirect light"]["required"]);
    EXPECT_FALSE(lit["requirements"]["emission"]["required"]);
}

TEST(Info, WarnsOfCoarseCoordinates) {
    const TemporaryFolder folder;
    const std::string far =
        folder.write("far.obj", "v 1e6 1e6 1e6\nv 1000001 1e6 1e6\nv 1e6 1000001 1e6\nf 1 2 3\n");
    EXPECT_EQ(info({far})["warnings"].size(), 0u) << "they are taken from an origin nearby";
    // In a scene that moves away, the origin stays where it began.
    folder.write("near.obj", kTriangleObj);
    const json warnings =
        info({folder.write("away.scene", "<world><user position='1e6 0 5' lookat='1e6 0 0'/>"
                                         "<transformation><animation><key time='0' translation="
                                         "'0 0 0'/><key frame='1' translation='1e6 0 0'/>"
                                         "</animation><object file='near.obj'/></transformation>"
                                         "</world>"),
              "--frame", "1"})["warnings"];
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(warnings[0].get<std::string>().find("frame 1: coordinates are so large that float32 "
                                                  "resolves 0.0625"),
              std::string::npos)
        << warnings;
    EXPECT_EQ(info({folder.write("near.obj", kTriangleObj)})["warnings"].size(), 0u);
    const json flat = info({folder.write("flat.obj", "v 0 0 -2\nv 1 0 -2\nv 2 0 -2\nv 0 1 -2\n"
                                                     "f 1 2 3\nf 1 2 4\n")});
    EXPECT_EQ(flat["precision"]["triangles_without_area"], 1);
}

TEST(Info, JsonIsAloneOnStandardOutput) {
    const TemporaryFolder folder;
    const Outcome run = dirt(
        {"info", "--json", folder.write("a.obj", std::string("mtllib none.mtl\n") + kTriangleObj)});
    EXPECT_EQ(run.status, 0);
    EXPECT_TRUE(json::accept(run.out));
}

TEST(Info, ABareObjGetsACameraOfItsOwn) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("a.obj", kTriangleObj);
    const json chosen = info({scene});
    EXPECT_EQ(chosen["lights"], 1);
    EXPECT_EQ(chosen["background"], json({0.5, 0.5, 0.5}));
    EXPECT_EQ(info({scene})["camera"], chosen["camera"]);

    const json given = info({scene, "--eye", "0,0,5", "--target", "0,0,0", "--up", "1,0,0"});
    EXPECT_EQ(given["camera"]["eye"], json({0.0, 0.0, 5.0}));
    EXPECT_EQ(given["camera"]["target"], json({0.0, 0.0, 0.0}));
    EXPECT_EQ(given["camera"]["up"], json({1.0, 0.0, 0.0}));
}

TEST(Info, TheGeneralOnesNeedNoScene) {
    EXPECT_EQ(dirt({}).status, 0);
    EXPECT_EQ(dirt({"--help"}).status, 0);
    EXPECT_NE(dirt({"info", "--help"}).out.find("--tile"), std::string::npos);
    EXPECT_EQ(dirt({"--version"}).out.rfind("dirt ", 0), 0u);
    EXPECT_NE(dirt({"generate", "--list"}).out.find("atrium"), std::string::npos);
}

} // namespace
} // namespace dirt::test
