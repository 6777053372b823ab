// `dirt render`: the files it writes, and what it reports.

#include "core/io/image.h"
#include "tests/cli/program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace dirt::test {
namespace {

using nlohmann::json;

/// `dirt render` of a small picture of litTriangle, with \p more arguments.
Outcome render(const TemporaryFolder& folder, const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"render", litTriangle(folder), "--size", "40x20", "--spp",
                                          "3"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return dirt(arguments);
}

TEST(Render, WritesExrAndPng) {
    const TemporaryFolder folder;
    for (const char* name : {"a.exr", "a.png"}) {
        const Outcome run = render(folder, {"-o", folder / name});
        ASSERT_EQ(run.status, 0) << run.err;
        EXPECT_TRUE(run.out.empty()) << run.out;
        const Image image = readImage(folder / name);
        EXPECT_EQ(image.width, 40);
        EXPECT_EQ(image.height, 20);
    }
    const Image image = readImage(folder / "a.exr");
    EXPECT_EQ(image.pixels[0], glm::vec3(0.25f, 0.5f, 1.0f)) << "the background, linear";
    EXPECT_GT(image.pixels[10 * 40 + 20].x, 0.0f) << "the triangle, lit";
}

TEST(Render, EqualRendersAreEqualFiles) {
    const TemporaryFolder folder;
    const std::vector<std::string> runs[] = {{"--threads", "1"}, {"--threads", "2"}};
    for (const char* kind : {".exr", ".png"}) {
        std::string first;
        for (const auto& options : runs) {
            std::vector<std::string> arguments = options;
            const std::string name = folder / (options[1] + kind);
            arguments.insert(arguments.end(), {"-o", name});
            ASSERT_EQ(render(folder, arguments).status, 0);
            if (first.empty()) first = readFile(name);
            EXPECT_EQ(readFile(name), first);
        }
    }
}

TEST(Render, StatsHaveTheirKeys) {
    const TemporaryFolder folder;
    const Outcome run =
        render(folder, {"-o", folder / "a.exr", "--stats", folder / "a.json", "--json"});
    ASSERT_EQ(run.status, 0) << run.err;
    const json stats = json::parse(readFile(folder / "a.json"));
    EXPECT_EQ(json::parse(run.out), stats);
    for (const char* key :
         {"scene",    "backend",  "device", "triangles",    "view",    "views",  "tile",
          "bins",     "size",     "spp",    "bounces",      "threads", "passes", "build_ms",
          "trace_ms", "frame_ms", "memory", "list_entries", "rays",    "hits"})
        EXPECT_TRUE(stats.contains(key)) << key;
    EXPECT_EQ(stats["spp"], 3);
    EXPECT_GE(stats["rays"], 40 * 20 * 3);
    EXPECT_GT(stats["hits"], 0);
    EXPECT_GT(stats["memory"]["total"], stats["memory"]["shading buffer G[k+1]"]);
    for (const json& pass : stats["passes"])
        EXPECT_TRUE(pass.contains("name") && pass.contains("ms") && pass.contains("event"));
}

} // namespace
} // namespace dirt::test
