// `dirt bench tradeoff` and `dirt bench scaling`: what they write, and what they refuse.

#include "bench/plot.h"
#include "bench/scaling_bench.h"
#include "bench/sweeps.h"
#include "core/io/image.h"
#include "tests/cli/program.h"

#include <nlohmann/json.hpp>

#include <algorithm>

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

/// Of a small picture, with \p more options.
Outcome tradeoff(const std::string& output, const std::vector<std::string>& more) {
    std::vector<std::string> arguments{
        "bench",  "tradeoff", DIRT_SOURCE_DIR "/scenes/cornell.scene",
        "--size", "32x16",    "--rounds",
        "1",      "--json",   "--quiet",
        "-o",     output};
    // Known errors have their samples.
    if (std::find(more.begin(), more.end(), "--errors") == more.end())
        arguments.insert(arguments.end(), {"--error-spp", "2", "--reference-spp", "4"});
    arguments.insert(arguments.end(), more.begin(), more.end());
    return dirt::test::dirt(arguments);
}

/// What \p key is in all rows of a report's table.
std::vector<json> column(const json& rows, const char* key) {
    std::vector<json> values;
    for (const json& row : rows) values.push_back(row.at(key));
    return values;
}

/// The bytes of a frame of one sample, by a program that has done nothing else.
json bytesAlone(const json& report, const std::string& sweep, const std::string& value,
                const TemporaryFolder& folder) {
    const Outcome run = dirt::test::dirt(
        {"render", DIRT_SOURCE_DIR "/scenes/cornell.scene", "--size", "32x16", "--spp", "1",
         "--tile", report["tile"].dump(), "--bins", report["bins"].dump(), "--" + sweep, value,
         "-o", folder / "one.exr", "--json", "--quiet"});
    EXPECT_EQ(run.status, 0) << run.err;
    return json::parse(run.out)["memory"]["total"];
}

TEST(BenchTradeoff, WritesTablesPlotsAndPictures) {
    const TemporaryFolder folder;
    const Outcome run = tradeoff(folder / "out", {});
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(run.err, "");
    const json report = json::parse(run.out);
    EXPECT_EQ(report, json::parse(readFile(folder / "out/cornell-tradeoff.json")));

    bool fewerBounces = false;
    for (const json& point : report["points"]) {
        EXPECT_GT(point["sample_ms"], 0);
        const std::string sweep = point["sweep"];
        // Whatever frames of other settings came before.
        if (sweep == "tile" || sweep == "shading" || sweep == "view" || sweep == "bounces") {
            EXPECT_EQ(point["memory"], bytesAlone(report, sweep, point["value"], folder))
                << point.dump();
        }
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

TEST(BenchTradeoff, TakesErrorsApartFromTimes) {
    const TemporaryFolder folder;
    const std::string references = folder / "references";
    const Outcome first = tradeoff(folder / "first", {"--references", references});
    ASSERT_EQ(first.status, 0) << first.err;
    EXPECT_EQ(TemporaryFolder::namesIn(references),
              (std::set<std::string>{"cornell-3.exr", "cornell-6.exr"}));
    const json errors = json::parse(first.out)["errors"];

    // The references are read: doubled, they make other errors.
    const std::string file = references + "/cornell-3.exr";
    dirt::Image image = dirt::readImage(file);
    const dirt::ImageMetadata metadata = dirt::readMetadata(file);
    for (glm::vec3& pixel : image.pixels) pixel *= 2.0f;
    dirt::writeExr(file, image, metadata);
    const Outcome doubled = tradeoff(folder / "doubled", {"--references", references});
    ASSERT_EQ(doubled.status, 0) << doubled.err;
    EXPECT_NE(json::parse(doubled.out)["errors"][0]["flip"], errors[0]["flip"]);

    // Known errors are those of the file.
    const std::string known = folder / "first/cornell-tradeoff.json";
    const Outcome times = tradeoff(folder / "times", {"--errors", known});
    ASSERT_EQ(times.status, 0) << times.err;
    for (const char* key : {"settings", "samples", "relative_mse", "flip"})
        EXPECT_EQ(column(json::parse(times.out)["errors"], key), column(errors, key)) << key;
    EXPECT_FALSE(TemporaryFolder::namesIn(folder / "times").contains("cornell-as-given.png"));
    EXPECT_TRUE(TemporaryFolder::namesIn(folder / "times").contains("cornell-error.svg"));

    // What is of another picture, or of none, is refused.
    const auto refuses = [&](const std::string& said, const std::vector<std::string>& more) {
        const Outcome run = tradeoff(folder / "refused", more);
        EXPECT_EQ(run.status, 2) << said;
        EXPECT_NE(run.err.find(said), std::string::npos) << run.err;
        EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    };
    refuses("its size is 32x16, not 16x16", {"--references", references, "--size", "16x16"});
    refuses("its seed is 1, not 5", {"--references", references, "--seed", "4"});
    refuses("its camera is --eye=", {"--references", references, "--eye=0,1,2"});
    refuses("its size is [32,16], not [16,16]", {"--errors", known, "--size", "16x16"});
    refuses("its camera is ", {"--errors", known, "--eye=0,1,2"});
    refuses("is not the JSON of", {"--errors", folder.write("a.json", "{\"scene\": ")});
    refuses("is not the JSON of", {"--errors", folder.write("b.json", "{}")});
    refuses("--error-spp excludes --errors", {"--errors", known, "--error-spp", "3"});
    refuses("none.json", {"--errors", folder / "none.json"});
    json other = json::parse(readFile(known));
    other["points"].erase(3);
    refuses("of other sweeps", {"--errors", folder.write("c.json", other.dump())});
    other = json::parse(readFile(known));
    other["errors"] = json::array();
    refuses("has no errors of settings 0", {"--errors", folder.write("d.json", other.dump())});
    folder.write("references/cornell-3.exr", "no image");
    refuses("cornell-3.exr", {"--references", references});
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
