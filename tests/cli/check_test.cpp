#include "tests/cli/program.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <sstream>

#include <nlohmann/json.hpp>

namespace dirt::test {
namespace {

bool hasGl() {
    return dirt({"info", "--devices"}).status == 0;
}

TEST(Check, ABackendAgreesWithItself) {
    const TemporaryFolder folder;
    const Outcome run = dirt(
        {"check", litTriangle(folder), "--backends", "cpu,cpu", "--tile", "4", "--size", "64x64"});
    EXPECT_EQ(run.status, 0) << run.err;
    for (const char* row :
         {"FillDepth          depth bounds             cpu on cpu",
          "DirectVisibility 0 shading buffer G[k+1]    cpu on cpu",
          "Trace 2            hit buffer               cpu on cpu", "image mean of cpu"})
        EXPECT_NE(run.out.find(row), run.out.npos) << row << "\n" << run.out;
    EXPECT_NE(run.out.find("\n0 wrong list entries\n"), run.out.npos) << run.out;
}

TEST(Check, BackendsThatAreNoneAreNamed) {
    const TemporaryFolder folder;
    const std::string scene = litTriangle(folder);
    for (const char* backends : {"cpu", "cpu,optix", "cpu,cpu,cpu"}) {
        const Outcome run = dirt({"check", scene, "--backends", backends});
        EXPECT_EQ(run.status, 2);
        EXPECT_NE(run.err.find("--backends"), run.err.npos) << run.err;
    }
}

/// Nothing is promised of it that could be compared.
TEST(Check, RefusesFast) {
    const TemporaryFolder folder;
    const Outcome run =
        dirt({"check", litTriangle(folder), "--backends", "cpu,cpu", "--precision", "fast"});
    EXPECT_EQ(run.status, 2);
    EXPECT_TRUE(run.err.starts_with("dirt: check: --precision fast promises nothing")) << run.err;
}

TEST(Check, RunsOneSample) {
    const TemporaryFolder folder;
    const Outcome run = dirt({"check", litTriangle(folder), "--backends", "cpu,cpu", "--spp", "2"});
    EXPECT_EQ(run.status, 2);
    EXPECT_EQ(run.err, "dirt: --spp: has no effect in dirt check\n");
}

TEST(Check, ReportsTheRowsOfASampleAsJson) {
    const TemporaryFolder folder;
    const Outcome run = dirt({"check", litTriangle(folder), "--backends", "cpu,cpu", "--json",
                              "--size", "64x32", "--bounces", "2", "--primary", "traced"});
    ASSERT_EQ(run.status, 0) << run.err;
    const auto json = nlohmann::json::parse(run.out);
    std::map<std::pair<std::string, int>, int> rows;
    for (const auto& row : json["rows"]) {
        if (row["event"].is_null()) continue;
        ++rows[{row["pass"], row["event"]}];
        EXPECT_EQ(row["compared"], 64 * 32) << row;
        EXPECT_EQ(row["equal"], 64 * 32) << row;
        EXPECT_EQ(row["different"], 0) << row;
    }
    const std::map<std::pair<std::string, int>, int> expected = {
        {{"Clear", 0}, 2},      {{"Rays", 0}, 2},  {{"Trace", 0}, 2},  {{"Fetch", 0}, 4},
        {{"Visibility", 0}, 2}, {{"Shade", 0}, 2}, {{"Shift", 0}, 4},  {{"DepthMask", 1}, 2},
        {{"Rays", 1}, 2},       {{"Trace", 1}, 2}, {{"Fetch", 1}, 4},  {{"Visibility", 1}, 2},
        {{"Shade", 1}, 2},      {{"Shift", 1}, 4}, {{"Resolve", 0}, 2}};
    EXPECT_EQ(rows, expected);
    EXPECT_EQ(json["image_means"][0], json["image_means"][1]);
    EXPECT_GT(json["image_means"][0][2], 0.0);
}

TEST(Check, ReportsRowsAsJson) {
    if (!hasGl()) GTEST_SKIP() << "there is no OpenGL";
    const TemporaryFolder folder;
    const Outcome run = dirt({"check", litTriangle(folder), "--json", "--size", "64x64"});
    ASSERT_EQ(run.status, 0) << run.err;
    const auto json = nlohmann::json::parse(run.out);
    EXPECT_EQ(json["wrong_entries"], 0);
    EXPECT_EQ(json["triangles"], 1);
    uint64_t lists = 0;
    for (const auto& row : json["rows"]) {
        EXPECT_EQ(row["compared"], row["equal"]) << row;
        if (row["buffer"] == "lists") lists += row["compared"].get<uint64_t>();
    }
    EXPECT_GT(lists, 0u);
}

TEST(Check, ShowsADifferenceAndHowToSeeItAgain) {
    if (!hasGl()) GTEST_SKIP() << "there is no OpenGL";
    const TemporaryFolder folder;
    const std::filesystem::path shaders = folder.path() / "shaders";
    std::filesystem::copy(DIRT_SOURCE_DIR "/shaders", shaders,
                          std::filesystem::copy_options::recursive);
    std::string source = readFile(shaders / "fill_primitives.frag");
    const std::string whole = "bin <= last", less = "bin < last";
    ASSERT_NE(source.find(whole), source.npos);
    source.replace(source.find(whole), whole.size(), less);
    folder.write("shaders/fill_primitives.frag", source);
    const std::string scene = litTriangle(folder);
    const Outcome run =
        startDirt({"check", scene, "--size", "64x64", "--bounces", "1", "--seed", "5", "--fetch",
                   "direct", "--traversal", "linear", "--tile", "16", "--bins", "16"},
                  [&] { setenv("DIRT_SHADERS", shaders.c_str(), 1); });
    EXPECT_EQ(run.status, 1) << run.err;
    EXPECT_NE(run.err.find("lacks triangle 0"), run.err.npos) << run.err;
    EXPECT_NE(run.err.find("again: DIRT_SHADERS=" + shaders.string() + " dirt check " + scene +
                           " --backends cpu,gl --view full --size 64x64 --tile 16 --bins 16 "
                           "--traversal linear --eye 0,0,0 "),
              run.err.npos)
        << run.err;
    EXPECT_NE(run.err.find(" --primary raster --fetch direct --visibility traced "
                           "--bounces 1 --seed 5\n"),
              run.err.npos)
        << run.err;
    EXPECT_EQ(startDirt(saidCommand(run.err, "again: "),
                        [&] { setenv("DIRT_SHADERS", shaders.c_str(), 1); })
                  .err,
              run.err);
    // Each missing entry counts once, and in no row but that of FillPrimitives.
    const size_t count = run.out.find(" wrong list entries");
    ASSERT_NE(count, run.out.npos) << run.out;
    const size_t line = run.out.rfind('\n', count) + 1;
    const int wrong = std::stoi(run.out.substr(line, count - line));
    EXPECT_GT(wrong, 0);
    std::istringstream rows(run.out.substr(0, line));
    for (std::string row; std::getline(rows, row);) {
        const std::string last = row.substr(row.find_last_of(' ') + 1);
        if (row.starts_with("pass")) continue;
        EXPECT_EQ(last, row.starts_with("FillPrimitives     lists") ? std::to_string(wrong) : "0")
            << row;
    }
    // The last line shows the first difference: an entry that is due and not listed.
    EXPECT_EQ(run.err.find('\n', run.err.rfind("look: ")), run.err.size() - 1) << run.err;
    const Outcome look = startDirt(saidCommand(run.err, "look: "),
                                   [&] { setenv("DIRT_SHADERS", shaders.c_str(), 1); });
    EXPECT_EQ(look.status, 1) << look.err << run.err;
    EXPECT_NE(look.out.find("; LISTED IN"), look.out.npos) << look.out;
}

/// A path's difference ends with the command that explains its pixel.
TEST(Check, ShowsThePixelThatDiffers) {
    if (!hasGl()) GTEST_SKIP() << "there is no OpenGL";
    const TemporaryFolder folder;
    const std::filesystem::path shaders = folder.path() / "shaders";
    std::filesystem::copy(DIRT_SOURCE_DIR "/shaders", shaders,
                          std::filesystem::copy_options::recursive);
    std::string source = readFile(shaders / "visibility.comp");
    const size_t at = source.rfind('}');
    ASSERT_NE(at, source.npos);
    folder.write("shaders/visibility.comp",
                 source.insert(at, "    if (firstPixel + i == 36u * 64u + 32u) "
                                   "imageStore(visibility, int(firstPixel + i), uvec4(0u));\n"));
    const auto broken = [&] { setenv("DIRT_SHADERS", shaders.c_str(), 1); };
    const Outcome run = startDirt({"check", litTriangle(folder), "--size", "64x64", "--bounces",
                                   "1", "--device", "0", "--materials", "demo"},
                                  broken);
    ASSERT_EQ(run.status, 1) << run.err;
    const std::vector<std::string> look = saidCommand(run.err, "look: ");
    ASSERT_GT(look.size(), 5u) << run.err;
    EXPECT_EQ((std::vector<std::string>(look.begin() + 2, look.begin() + 8)),
              (std::vector<std::string>{"--pixel", "32,36", "--event", "0", "--backend", "gl"}));
    EXPECT_NE(run.err.find(" --materials demo\n"), run.err.npos) << run.err;
    const Outcome shown = startDirt(look, broken);
    EXPECT_EQ(shown.status, 1) << shown.err;
    EXPECT_NE(shown.out.find("DIFFERENT: the backend says that the light does not reach"),
              shown.out.npos)
        << shown.out;
}

} // namespace
} // namespace dirt::test
