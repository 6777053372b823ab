// `dirt bench frame`: its JSON, and what it refuses.

#include "tests/cli/program.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

using namespace dirt::test;
using nlohmann::json;

#ifdef DIRT_HAVE_EMBREE

TEST(BenchFrame, JsonHasTimesRatiosWorkAndMemoryOfEachScene) {
    const TemporaryFolder folder;
    const std::string cornell = DIRT_SOURCE_DIR "/scenes/cornell.scene";
    const std::string one = folder.write("one.obj", kTriangleObj);
    const Outcome run =
        dirt::test::dirt({"bench", "frame", cornell, one, "--size", "40x30", "--rounds", "3",
                          "--json", "--quiet", "--eye", "0,0,0", "--target", "0,0,-1"});
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(run.err, "");
    const json report = json::parse(run.out);
    EXPECT_EQ(report["rounds"], 3);
    ASSERT_EQ(report["scenes"].size(), 2u);
    const json& scene = report["scenes"][0];
    EXPECT_EQ(scene["scene"], "cornell");
    EXPECT_EQ(report["scenes"][1]["triangles"], 1);
    EXPECT_EQ(scene["work"]["primary"]["rays"], 40 * 30);
    for (const char* part : {"build", "primary", "trace", "shadow", "frame"}) {
        const double dirt = scene["dirt_ms"][part], embree = scene["embree_ms"][part];
        EXPECT_DOUBLE_EQ(scene["ratio"][part], dirt / embree) << part;
        EXPECT_LE(scene["spread"]["dirt_least_ms"][part], dirt) << part;
        EXPECT_GE(scene["spread"]["embree_most_ms"][part], embree) << part;
    }
    EXPECT_DOUBLE_EQ(scene["embree_morton"]["build_ratio"],
                     (double) scene["dirt_ms"]["build"] /
                         (double) scene["embree_morton"]["build_ms"]);
    EXPECT_EQ(scene["build_floor"]["bytes"], scene["memory"]["dirt_ads"]);
    EXPECT_GT(scene["build_floor"]["ms"], 0.0);
    EXPECT_GT(scene["memory"]["dirt_ads"], 0);
    EXPECT_GT(scene["memory"]["embree_bvh"], 0);
}

#else

TEST(BenchFrame, SaysThatItNeedsEmbree) {
    EXPECT_EQ(dirt::test::dirt({"bench", "frame", "any.obj"}).status, 3);
}

#endif

TEST(BenchFrame, RefusesNoSceneAndNoRounds) {
    EXPECT_EQ(dirt::test::dirt({"bench", "frame"}).status, 2);
    EXPECT_EQ(dirt::test::dirt({"bench", "frame", "any.obj", "--rounds", "0"}).status, 2);
    EXPECT_EQ(dirt::test::dirt({"bench"}).status, 2);
}
