// `dirt bench tradeoff` and `dirt bench scaling`: what they write, and what they refuse.

#include "bench/plot.h"
#include "bench/scaling_bench.h"
#include "bench/sweeps.h"
#include "tests/cli/program.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

using namespace dirt::test;
using nlohmann::json;

TEST(Sweeps, AroundTheirSettingsAndWithoutRepetition) {
    dirt::RenderSettings around;
    around.grid.tile = 24; // on no sweep
    const dirt::Sweeps sweeps = dirt::makeSweeps(around);
    EXPECT_EQ(sweeps.settings.front(), around);
    for (size_t i = 0; i < sweeps.settings.size(); ++i)
        for (size_t k = 0; k < i; ++k) EXPECT_FALSE(sweeps.settings[i] == sweeps.settings[k]);
    for (const dirt::Sweep& sweep : sweeps.sweeps)
        for (const auto& [value, index] : sweep.points) {
            const dirt::RenderSettings& settings = sweeps.settings.at(index);
            const bool varied = sweep.name.starts_with("tile");
            EXPECT_EQ(settings.grid.tile, varied ? std::stoi(value) : 24) << sweep.name;
        }
}

TEST(Plot, PutsPointsWhereTheirLogarithmsAre) {
    const std::string svg =
        dirt::svgOf({"<title>", "x", "y", {{"line", {{1, 10}, {10, 100}, {100, 1000}}}}});
    // The middle point lies in the middle of the frame.
    EXPECT_NE(svg.find("<circle cx='260.0' cy='147.0'"), std::string::npos) << svg;
    EXPECT_NE(svg.find("&lt;title>"), std::string::npos);
    EXPECT_EQ(svg.find("nan"), std::string::npos);
}

TEST(Scaling, FitsTheExponentOfAPower) {
    EXPECT_NEAR(dirt::fittedExponent({1, 10, 1000}, {3, 3 * 12.589254, 3 * 1995.2623}), 1.1, 1e-6);
}

#ifdef DIRT_HAVE_EMBREE

TEST(BenchTradeoff, WritesTablesPlotsAndPictures) {
    const TemporaryFolder folder;
    const std::string cornell = DIRT_SOURCE_DIR "/scenes/cornell.scene";
    const Outcome run = dirt::test::dirt({"bench", "tradeoff", cornell, "--size", "32x16",
                                          "--rounds", "1", "--error-spp", "2", "--reference-spp",
                                          "4", "-o", folder / "out", "--json", "--quiet"});
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(run.err, "");
    const json report = json::parse(run.out);
    EXPECT_EQ(report, json::parse(readFile(folder / "out/cornell-tradeoff.json")));

    bool fewerBounces = false;
    for (const json& point : report["points"]) {
        EXPECT_GT(point["sample_ms"], 0);
        EXPECT_GT(point["memory"], 0);
        const std::string sweep = point["sweep"];
        // Precision, shading, visibility, views and bounces decide which image is found, and
        // nothing else.
        if (sweep != "precision" && sweep != "shading" && sweep != "visibility" &&
            sweep != "view" && sweep != "bounces") {
            EXPECT_EQ(point["same_image_as"], 0) << point.dump();
        }
        if (sweep == "bounces" && point["value"] == "1") {
            EXPECT_NE(point["same_image_as"], 0);
            fewerBounces = true;
        }
    }
    EXPECT_TRUE(fewerBounces);
    for (const json& error : report["errors"]) {
        EXPECT_GT(error["relative_mse"], 0) << error.dump();
        EXPECT_GT(error["flip"], 0);
    }
    EXPECT_EQ(report["errors"][1]["samples"], 2);

    const auto rows = [&](const char* file) {
        const std::string csv = readFile(folder / (std::string("out/") + file));
        return std::count(csv.begin(), csv.end(), '\n') - 1;
    };
    EXPECT_EQ(rows("cornell-tradeoff.csv"), (ptrdiff_t) report["points"].size());
    EXPECT_EQ(rows("cornell-errors.csv"), (ptrdiff_t) report["errors"].size());
    const auto names = TemporaryFolder::namesIn(folder / "out");
    for (const char* file :
         {"cornell-time-tile.svg", "cornell-time-bins.svg", "cornell-memory.svg",
          "cornell-error.svg", "cornell-as-given.png", "cornell-bounces-1-error.png"})
        EXPECT_TRUE(names.contains(file)) << file;
}

TEST(BenchScaling, TimesTwoSizesOfAtriumAndLeavesNoScene) {
    if (!std::getenv("DIRT_TEST_FULL")) GTEST_SKIP() << "writes and loads scenes: in the long form";
    const TemporaryFolder folder;
    const Outcome run = dirt::test::dirt({"bench", "scaling", "--rounds", "1", "--most", "30000",
                                          "-o", folder / "out", "--json", "--quiet"});
    ASSERT_EQ(run.status, 0) << run.err;
    const json report = json::parse(run.out);
    ASSERT_EQ(report["triangles"].size(), 2u);
    EXPECT_LT(report["triangles"][0]["triangles"], report["triangles"][1]["triangles"]);
    EXPECT_EQ(report["sizes"].size(), 5u);
    EXPECT_EQ(TemporaryFolder::namesIn(folder / "out"),
              (std::set<std::string>{"scaling.json", "scaling-size.svg", "scaling-triangles.svg"}));
}

#else

TEST(BenchTradeoff, SaysThatItNeedsEmbree) {
    const TemporaryFolder folder;
    EXPECT_EQ(dirt::test::dirt({"bench", "tradeoff", "any.obj", "-o", folder / "out"}).status, 3);
    EXPECT_EQ(dirt::test::dirt({"bench", "scaling", "-o", folder / "out"}).status, 3);
}

#endif

TEST(BenchTradeoff, RefusesToWriteNowhere) {
    EXPECT_EQ(dirt::test::dirt({"bench", "tradeoff", "any.obj"}).status, 2);
    EXPECT_EQ(dirt::test::dirt({"bench", "scaling"}).status, 2);
}
