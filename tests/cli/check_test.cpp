#include "tests/cli/program.h"

#include <gtest/gtest.h>

#include <filesystem>

#include <nlohmann/json.hpp>

namespace dirt::test {
namespace {

bool hasGl() {
    return dirt({"info", "--devices"}).status == 0;
}

TEST(Check, ABackendAgreesWithItself) {
    const TemporaryFolder folder;
    const Outcome run =
        dirt({"check", litTriangle(folder), "--backends", "cpu,cpu", "--tile", "4"});
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_NE(run.out.find("FillDepth        depth bounds             cpu on cpu"), run.out.npos)
        << run.out;
    EXPECT_NE(run.out.find("\n0 wrong list entries\n"), run.out.npos) << run.out;
}

TEST(Check, BackendsThatAreNoneAreNamed) {
    const TemporaryFolder folder;
    const std::string scene = litTriangle(folder);
    for (const char* backends : {"cpu", "cpu,embree", "cpu,cpu,cpu"}) {
        const Outcome run = dirt({"check", scene, "--backends", backends});
        EXPECT_EQ(run.status, 2);
        EXPECT_NE(run.err.find("--backends"), run.err.npos) << run.err;
    }
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
    const Outcome run = startDirt({"check", litTriangle(folder), "--size", "64x64"},
                                  [&] { setenv("DIRT_SHADERS", shaders.c_str(), 1); });
    EXPECT_EQ(run.status, 1) << run.err;
    EXPECT_NE(run.err.find("lacks triangle 0"), run.err.npos) << run.err;
    EXPECT_NE(run.err.find("again: dirt check "), run.err.npos) << run.err;
    EXPECT_EQ(run.out.find("\n0 wrong list entries"), run.out.npos) << run.out;
}

} // namespace
} // namespace dirt::test
