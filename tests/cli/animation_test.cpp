// `dirt render --frames` and `--frame`: pictures of a scene that moves.

#include "core/io/image.h"
#include "tests/cli/program.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <thread>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace dirt::test {
namespace {

using nlohmann::json;

constexpr int kFrames = 60;

/// A floor, a fan of triangles with normals that tumbles over it, and a camera that passes by.
std::string animatedScene(const TemporaryFolder& folder) {
    folder.write("floor.obj", "v -4 -1 -8\nv 4 -1 -8\nv 4 -1 1\nv -4 -1 1\nf 1 4 3 2\n");
    folder.write("fan.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv -1 0 0\nvn 1 1 1\nvn -1 1 1\n"
                            "f 2//1 3//1 4//1\nf 5//2 4//2 3//2\nf 1 2 4\nf 1 3 2\n");
    return folder.write(
        "a.scene",
        "<world background='0.2 0.3 0.4' fps='20'><object file='floor.obj'/>"
        "<light position='2 4 2' target='0 0 -3' flux='80' aperture='100'/>"
        "<user position='0 1 3' lookat='0 0 -3'><animation><key time='0' position='-1 1 3'/>"
        "<key time='3' position='1 1.5 2.5'/></animation></user>"
        "<transformation translation='0 0 -3'><transformation><animation>"
        "<key frame='0' translation='-2 0 0' rotation='0 1 1 0'/>"
        "<key frame='25' translation='0 1 0' rotation='170 1 1 0' scale='1 1 1'/>"
        "<key frame='59' translation='2 0 0' rotation='20 0 1 1' scale='1.5 .5 1'/>"
        "</animation><object file='fan.obj'/></transformation></transformation></world>");
}

std::vector<std::string> render(const std::string& scene, std::vector<std::string> more) {
    more.insert(more.begin(), {"render", scene, "--size", "48x32", "--spp", "2"});
    return more;
}

std::string numbered(const std::string& stem, int frame) {
    char number[16];
    std::snprintf(number, sizeof number, ".%04d.exr", frame);
    return stem + number;
}

class AnimationFrames : public testing::Test {
protected:
    /// Renders frames as NAME.….exr.
    void renderFrames(const std::string& name, int first, int last,
                      std::vector<std::string> more = {}) {
        more.insert(more.end(), {"--frames", std::to_string(first) + ":" + std::to_string(last),
                                 "-o", folder_ / (name + ".exr")});
        const Outcome run = dirt(render(scene_, more));
        ASSERT_EQ(run.status, 0) << run.err;
    }
    std::string frame(const std::string& name, int k) {
        return readFile(folder_ / numbered(name, k));
    }

    TemporaryFolder folder_;
    const std::string scene_ = animatedScene(folder_);
};

TEST_F(AnimationFrames, AreTheSameFromWhereverTheyBegin) {
    renderFrames("whole", 0, kFrames - 1);
    renderFrames("part", 37, 41, {"--threads", "3"});
    std::set<std::string> different;
    for (int k = 0; k < kFrames; ++k) different.insert(frame("whole", k));
    EXPECT_EQ(different.size(), (size_t) kFrames) << "something moves in every frame";
    for (int k = 37; k <= 41; ++k) EXPECT_TRUE(frame("part", k) == frame("whole", k)) << k;
    for (int k : {0, 59}) {
        const std::string file = folder_ / "single.exr";
        ASSERT_EQ(dirt(render(scene_, {"--frame", std::to_string(k), "-o", file})).status, 0);
        EXPECT_TRUE(readFile(file) == frame("whole", k)) << k;
    }
    // Held after the last key, the camera's at frame 60.
    renderFrames("held", 60, 61);
    EXPECT_EQ(readImage(folder_ / numbered("held", 60)).pixels,
              readImage(folder_ / numbered("held", 61)).pixels);
}

TEST_F(AnimationFrames, ShowWhatEmbreeShows) {
#ifndef DIRT_HAVE_EMBREE
    GTEST_SKIP() << "built without Embree";
#endif
    for (const char* view : {"full", "single"}) {
        renderFrames("cpu", 0, kFrames - 1, {"--view", view});
        renderFrames("embree", 0, kFrames - 1, {"--view", view, "--backend", "embree"});
        for (int k = 0; k < kFrames; ++k)
            EXPECT_EQ(readImage(folder_ / numbered("cpu", k)).pixels,
                      readImage(folder_ / numbered("embree", k)).pixels)
                << view << ' ' << k;
    }
}

TEST_F(AnimationFrames, AreNumberedBesideTheOutput) {
    const std::string stats = folder_ / "stats.json";
    const Outcome run = dirt(render(
        scene_, {"--frames", "9:10", "-o", folder_ / "my.movie.png", "--stats", stats, "--json"}));
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(run.err,
              folder_ / "my.movie.0009.png" + "\n" + (folder_ / "my.movie.0010.png") + "\n");
    const json report = json::parse(run.out);
    EXPECT_EQ(report, json::parse(readFile(stats)));
    ASSERT_EQ(report["frames"].size(), 2u);
    EXPECT_EQ(report["frames"][1]["animation_frame"], 10);
    EXPECT_TRUE(report["frames"][1].contains("frame_ms"));
}

TEST_F(AnimationFrames, AreVerifiedAndDumped) {
#ifdef DIRT_HAVE_EMBREE
    const Outcome verify = dirt({"verify", scene_, "--frame", "30", "--rays", "500", "--json"});
    EXPECT_EQ(verify.status, 0) << verify.err;
    EXPECT_EQ(json::parse(verify.out)["animation_frame"], 30);
#endif
    const Outcome first = dirt({"info", scene_, "--json"});
    const Outcome later = dirt({"info", scene_, "--json", "--frame", "59"});
    EXPECT_NE(json::parse(first.out)["bounds"], json::parse(later.out)["bounds"]);
    const json animation = json::parse(first.out)["animation"];
    EXPECT_EQ(animation["last_frame"], 60);
    EXPECT_EQ(animation["fps"], 20.0);
    EXPECT_EQ(animation["moving_vertices"], 5);
    EXPECT_EQ(animation["moving_camera"], true);
    const Outcome dump = dirt({"dump", scene_, "--frame", "5", "--size", "16x16", "--buffers",
                               "triangles", "-o", folder_ / "dump"});
    EXPECT_EQ(dump.status, 0) << dump.err;
    EXPECT_EQ(json::parse(readFile(folder_ / "dump/manifest.json"))["animation_frame"], 5);
}

TEST_F(AnimationFrames, RefuseWhatMakesNoSense) {
    const auto error = [&](std::vector<std::string> more) {
        const Outcome run = dirt(render(scene_, std::move(more)));
        EXPECT_EQ(run.status, 2);
        EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
        return run.err;
    };
    for (const char* range : {"3", "3:", ":3", "4:3", "-1:3", "0:1000000", "0:1:2", "a:b"})
        EXPECT_NE(error({"--frames", range}).find("--frames"), std::string::npos) << range;
    EXPECT_NE(error({"--frames", "0:1", "--frame", "1"}).find("exclude"), std::string::npos);
    EXPECT_NE(error({"--frame", "-1"}).find("--frame"), std::string::npos);
    std::filesystem::create_directory(folder_ / "a.0003.png");
    EXPECT_NE(error({"--frames", "0:5", "-o", folder_ / "a.png"}).find("a.0003.png: cannot write"),
              std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(folder_ / "a.0000.png")) << "nothing is begun in vain";
}

TEST_F(AnimationFrames, ACameraWithoutDirectionIsNamedWithItsFrame) {
    const std::string scene = folder_.write(
        "b.scene",
        "<world><object file='fan.obj'/><user position='0 0 5' lookat='0 0 0'><animation>"
        "<key frame='0' position='0 0 5'/><key frame='10' position='0 0 -5'/>"
        "</animation></user></world>");
    const Outcome run = dirt(render(scene, {"--frames", "0:9", "-o", folder_ / "b.png"}));
    EXPECT_EQ(run.status, 2);
    EXPECT_EQ(run.err, "dirt: frame 5, camera: eye and target are the same point\n");
    EXPECT_FALSE(std::filesystem::exists(folder_ / "b.0000.png"));
}

TEST_F(AnimationFrames, CtrlCKeepsThoseThatAreFinished) {
    std::vector<std::string> arguments = {"render",   scene_,  "--size",  "96x64",
                                          "--spp",    "8",     "-o",      folder_ / "a.exr",
                                          "--frames", "0:999", "--stats", folder_ / "a.json"};
    Process process(DIRT_PROGRAM, arguments, [] {});
    const auto start = std::chrono::steady_clock::now();
    while (!std::filesystem::exists(folder_ / numbered("a", 2)) &&
           std::chrono::steady_clock::now() - start < std::chrono::seconds(120))
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    kill(process.id(), SIGINT);
    const Outcome run = process.wait();
    EXPECT_EQ(run.status, 130) << run.err;
    size_t files = 0;
    while (std::filesystem::exists(folder_ / numbered("a", (int) files))) ++files;
    EXPECT_GE(files, 3u);
    EXPECT_LT(files, 1000u);
    const std::string last = "dirt: stopped in frame " + std::to_string(files) + ", " +
                             std::to_string(files) + " frames written\n";
    EXPECT_NE(run.err.find(last), std::string::npos) << run.err;
    EXPECT_EQ(json::parse(readFile(folder_ / "a.json"))["frames"].size(), files);
    EXPECT_EQ(folder_.names().size(), 3 + files + 1) << "no temporary file";
    const std::string again = folder_ / "again.exr";
    arguments = {"render", scene_, "--size", "96x64",   "--spp",
                 "8",      "-o",   again,    "--frame", std::to_string(files - 1)};
    ASSERT_EQ(dirt(arguments).status, 0);
    EXPECT_TRUE(readFile(again) == frame("a", (int) files - 1));
}

} // namespace
} // namespace dirt::test
