// `dirt render`: the files it writes, what it reports, and Ctrl-C.

#include "core/io/image.h"
#include "tests/cli/program.h"

#include <chrono>
#include <csignal>
#include <thread>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace dirt::test {
namespace {

using nlohmann::json;

/// A lit triangle before the camera.
std::string litTriangle(const TemporaryFolder& folder) {
    folder.write("a.obj", kTriangleObj);
    return folder.write("a.scene", "<world background=\"0.25 0.5 1\"><object file=\"a.obj\"/>"
                                   "<light type=\"spotlight\" position=\"0 0 0\" target=\"0 0 -1\" "
                                   "flux=\"20\" aperture=\"120\" penumbra=\"100\"/>"
                                   "<user position=\"0 0 0\" lookat=\"0 0 -1\"/></world>");
}

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

TEST(Render, BadOutputEndsBeforeTheRender) {
    const TemporaryFolder folder;
    for (const std::string& output : {folder / "missing/a.png", folder / "a.jpg"}) {
        // A render of this size would take minutes.
        const Outcome run = render(folder, {"--spp", "1000000", "-o", output});
        EXPECT_EQ(run.status, 2);
        EXPECT_NE(run.err.find(output), std::string::npos) << run.err;
        EXPECT_FALSE(std::filesystem::exists(output));
    }
    EXPECT_EQ(render(folder, {"-o", folder / "a.png", "--stats", "/dev/null"}).status, 2);
    EXPECT_FALSE(std::filesystem::exists(folder / "a.png"));
}

/// Starts an endless render, presses Ctrl-C after \p delay, and waits.
Outcome interruptedRender(const TemporaryFolder& folder, std::chrono::seconds delay) {
    const std::string scene = litTriangle(folder), output = folder / "a.exr";
    const std::string err = folder / "err";
    const pid_t child = fork();
    if (child == 0) {
        if (!std::freopen(err.c_str(), "w", stderr)) _exit(126);
        execl(DIRT_PROGRAM, "dirt", "render", scene.c_str(), "--size", "64x32", "--spp", "1000000",
              "-o", output.c_str(), (char*) nullptr);
        _exit(127);
    }
    std::this_thread::sleep_for(delay);
    kill(child, SIGINT);
    int state = 0;
    waitpid(child, &state, 0);
    Outcome run;
    run.status = WIFEXITED(state) ? WEXITSTATUS(state) : 128 + WTERMSIG(state);
    run.err = readFile(err);
    return run;
}

TEST(Render, CtrlCWritesWhatThereIs) {
    const TemporaryFolder folder;
    // A busy machine may not have got to the first sample yet.
    Outcome run;
    for (int seconds = 1; seconds <= 16 && !std::filesystem::exists(folder / "a.exr"); seconds *= 2)
        run = interruptedRender(folder, std::chrono::seconds(seconds));
    EXPECT_EQ(run.status, 130);
    int samples = 0;
    ASSERT_EQ(std::sscanf(run.err.c_str(), "dirt: stopped after %d of 1000000 samples", &samples),
              1)
        << run.err;
    ASSERT_GT(samples, 0);
    // The mean of equal values, whatever their number: each addition rounds once.
    const Image image = readImage(folder / "a.exr");
    EXPECT_NEAR(image.pixels[0].x, 0.25f, 0.25f * (float) (samples + 1) * 0x1p-24f);
}

} // namespace
} // namespace dirt::test
