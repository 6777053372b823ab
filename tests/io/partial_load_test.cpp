// Scenes that are shown while they are loaded: the models that are there, in their places, and no
// difference to what is loaded in the end.

#include "backend_cpu/thread_pool.h"
#include "core/io/load.h"
#include "core/io/partial_scenes.h"
#include "tests/io/input_error.h"
#include "tests/io/same_scene.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/write_image.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace dirt {
namespace {

class PartialLoadTest : public testing::Test {
protected:
    static constexpr int kModels = 5, kImages = 2;
    static constexpr const char* kCamera = "<user position='9 0 4' lookat='9 0 0'/>";

    /// Model i has i + 1 triangles; model 2 is placed twice, and model 3 moves.
    PartialLoadTest() {
        for (int i = 0; i < kModels; ++i) {
            const std::string n = std::to_string(i);
            std::string obj = "mtllib m" + n + ".mtl\nusemtl a" + n + "\nv 0 " + n +
                              " 0\nv 1 0 0\nv 0 1 0\nvt 0 0\n";
            for (int k = 0; k <= i; ++k) obj += "f 1/1 2/1 3/1\n";
            folder_.write("o" + n + ".obj", obj);
            folder_.write("m" + n + ".mtl", "newmtl a" + n + "\nKd .1 ." + n + " .3\nmap_Kd t" +
                                                std::to_string(i % kImages) +
                                                ".png\nNonsense 1\nmap_Ks none.png\n");
        }
        for (int i = 0; i < kImages; ++i)
            test::writeImage(folder_ / ("t" + std::to_string(i) + ".png"), 1, 1, 3, {50, 7, 9});
    }

    std::string writeScene(const std::string& before = kCamera, const char* attributes = "") {
        return folder_.write(
            "a.scene",
            std::string("<world ") + attributes + ">" + before +
                "<light position='0 9 0' target='0 0 0' flux='5'/>"
                "<object file='o0.obj'/><object file='o1.obj'/><object file='o2.obj'/>"
                "<transformation><animation><key time='0' translation='0 0 2'/>"
                "<key time='1' translation='0 0 3'/></animation><object file='o3.obj'/>"
                "</transformation><object file='o4.obj'/>"
                "<transformation translation='0 0 7'><object file='o2.obj'/></transformation>"
                "</world>");
    }

    /// Keeps what is shown.
    LoadOptions watched() {
        LoadOptions options;
        options.partial.show = [this](LoadedScene part) { parts_.push_back(std::move(part)); };
        return options;
    }

    std::vector<size_t> triangles() const {
        std::vector<size_t> counts;
        for (const LoadedScene& part : parts_) counts.push_back(part.scene.mesh.triangles.size());
        return counts;
    }

    test::TemporaryFolder folder_;
    std::vector<LoadedScene> parts_;
};

TEST_F(PartialLoadTest, EachModelIsThereWhenItIsRead) {
    const LoadedScene all = loadScene(writeScene(), watched());
    // Not after the last model, when images follow at once; then after the first of these.
    EXPECT_EQ(triangles(), (std::vector<size_t>{1, 3, 9, 13, 18}));
    EXPECT_EQ(all.scene.mesh.triangles.size(), 18u);
    for (const LoadedScene& part : parts_) {
        const Scene& scene = part.scene;
        EXPECT_TRUE(scene.textures.empty() && scene.scalarTextures.empty());
        ASSERT_FALSE(scene.materials.empty());
        EXPECT_EQ(scene.materials[0].diffuseMap, kNoTexture);
        EXPECT_EQ(scene.materials[0].name, "a0");
        EXPECT_TRUE(part.hasCamera && part.hasLight);
        EXPECT_EQ(scene.camera.eye, glm::vec3(9, 0, 4));
        EXPECT_EQ(scene.lights[0].position, glm::vec3(0, 9, 0));
        EXPECT_EQ(scene.name, "a");
    }
    // In their places, those that move at frame 0.
    EXPECT_TRUE(test::sameBits(parts_.back().scene.mesh.positions, all.scene.mesh.positions));
    EXPECT_TRUE(test::sameBits(parts_.back().scene.mesh.triangles, all.scene.mesh.triangles));
    EXPECT_EQ(parts_.back().scene.mesh.positions[9], glm::vec3(0, 3, 2));
    EXPECT_EQ(parts_.back().scene.animation.parts.size(), 1u);
    EXPECT_EQ(parts_[1].scene.animation.parts.size(), 0u);
}

TEST_F(PartialLoadTest, DoesNotChangeWhatIsLoaded) {
    const std::string scene = writeScene();
    LoadOptions plain;
    plain.memory = MemoryBudget(1 << 30);
    const LoadedScene expected = loadScene(scene, plain);
    EXPECT_FALSE(expected.warnings.empty() || expected.ignored.empty());
    ThreadPool threads(4);
    for (int round = 0; round < 20; ++round) {
        parts_.clear();
        LoadOptions options = watched();
        options.executor = &threads;
        options.memory = MemoryBudget(1 << 30);
        const LoadedScene loaded = loadScene(scene, options);
        test::expectSameScene(expected, loaded);
        EXPECT_EQ(options.memory.taken(), plain.memory.taken());
        // Whole models, more of them each time.
        const std::vector<size_t> counts = triangles();
        ASSERT_FALSE(counts.empty());
        EXPECT_TRUE(std::is_sorted(counts.begin(), counts.end(), std::less_equal<>()));
        EXPECT_EQ(counts.back(), 18u);
    }
}

/// What the load can do with is enough, with pictures or without.
TEST_F(PartialLoadTest, TakesNoMemoryFromTheLoad) {
    for (int i = 0; i < kModels; ++i) { // else all is too small to be counted
        const std::string name = "o" + std::to_string(i) + ".obj";
        std::string text = test::readFile(folder_ / name);
        for (int k = 0; k < 500; ++k) text += "f 1 2 3\n";
        folder_.write(name, text);
    }
    const std::string scene = writeScene();
    const auto loads = [&](LoadOptions options, uint64_t limit) {
        options.memory = MemoryBudget(limit);
        return inputError([&] { loadScene(scene, options); }).empty();
    };
    uint64_t tooLittle = 0, enough = 1 << 24;
    ASSERT_TRUE(loads({}, enough));
    while (enough - tooLittle > 1) {
        const uint64_t middle = (tooLittle + enough) / 2;
        (loads({}, middle) ? enough : tooLittle) = middle;
    }
    EXPECT_GT(enough, 100'000u);
    EXPECT_TRUE(loads(watched(), enough));
    EXPECT_FALSE(parts_.empty());
    EXPECT_FALSE(loads(watched(), enough - 1));
}

TEST_F(PartialLoadTest, IsMadeOnlyWhenItIsWanted) {
    int asked = 0;
    LoadOptions options = watched();
    options.partial.wanted = [&] { return ++asked == 3; };
    loadScene(writeScene(), options);
    EXPECT_EQ(asked, kModels);
    EXPECT_EQ(triangles(), (std::vector<size_t>{9}));
}

TEST_F(PartialLoadTest, CostsNothingWhereNoOneLooks) {
    int asked = 0, made = 0;
    PartialLoad noOne;
    noOne.wanted = [&] { return ++asked > 0; };
    PartialScenes scenes(noOne, 3, [&](const std::vector<bool>&) { return ++made, LoadedScene(); });
    EXPECT_FALSE(scenes.after({})) << "nothing to call";
    const LoadProgress progress = scenes.after([](size_t, size_t) {});
    scenes.add(1);
    progress(1, 3);
    EXPECT_EQ(asked + made, 0);
}

TEST_F(PartialLoadTest, IsShownOnlyWhereAllOfItWillBeSeenFrom) {
    loadScene(writeScene(""), watched());
    EXPECT_TRUE(parts_.empty()) << "without a camera";
    loadScene(writeScene(kCamera, "multithreaded_loading='false'"), watched());
    EXPECT_TRUE(parts_.empty()) << "where the file says no";
    loadScene(folder_ / "o4.obj", watched());
    EXPECT_TRUE(parts_.empty()) << "a model alone";
    loadScene(writeScene(kCamera, "multithreaded_loading='true'"), watched());
    EXPECT_EQ(parts_.size(), 5u);
}

TEST_F(PartialLoadTest, NothingIsNotShown) {
    folder_.write("o0.obj", "v 0 0 0\n");
    loadScene(writeScene(), watched());
    EXPECT_EQ(triangles(), (std::vector<size_t>{2, 8, 12, 17}));
}

/// Where no images are left to read, all of it is there at once.
TEST_F(PartialLoadTest, AllOfItIsNoPart) {
    for (int i = 0; i < kModels; ++i)
        folder_.write("m" + std::to_string(i) + ".mtl", "newmtl a" + std::to_string(i) + "\n");
    loadScene(writeScene(), watched());
    EXPECT_EQ(triangles(), (std::vector<size_t>{1, 3, 9, 13}));
}

/// Far from 0 a part has an origin of its own, and is seen from the same place all the same.
TEST_F(PartialLoadTest, StandsWhereItWillFarFromZero) {
    const std::string scene =
        folder_.write("far.scene", "<world><user position='1e6 0 9' lookat='1e6 0 0'/>"
                                   "<transformation translation='1e6 0 0'><object file='o0.obj'/>"
                                   "<transformation translation='300 0 0'><object file='o1.obj'/>"
                                   "</transformation></transformation></world>");
    const LoadedScene all = loadScene(scene, watched());
    ASSERT_EQ(parts_.size(), 2u);
    const Scene& part = parts_[0].scene;
    EXPECT_NE(part.origin, all.scene.origin);
    EXPECT_EQ(part.inFiles(part.camera.eye), glm::dvec3(1e6, 0, 9));
    EXPECT_EQ(part.inFiles(part.mesh.positions[1]), glm::dvec3(1e6 + 1, 0, 0));
}

/// A part may fail where the whole does not, and where it does, that is said as ever.
TEST_F(PartialLoadTest, WhatIsWrongWithAPartIsNotSaid) {
    PartialLoad watcher = watched().partial;
    int made = 0;
    PartialScenes scenes(watcher, 3, [&](const std::vector<bool>&) -> LoadedScene {
        ++made;
        throw InputError("wrong");
    });
    const LoadProgress progress = scenes.after({});
    for (size_t i = 0; i < 2; ++i) {
        scenes.add(i);
        progress(i + 1, 3);
    }
    EXPECT_EQ(made, 1) << "nor tried again";

    folder_.write("o1.obj", "v 3e38 0 0\nv 0 0 0\nv 0 3e38 0\nf 1 2 3");
    const std::string scene =
        folder_.write("a.scene", std::string("<world>") + kCamera +
                                     "<object file='o0.obj'/><transformation scale='9 9 9'>"
                                     "<object file='o1.obj'/></transformation>"
                                     "<object file='o2.obj'/></world>");
    const std::string expected = inputError([&] { loadScene(scene); });
    EXPECT_NE(expected.find("o1.obj:4"), std::string::npos) << expected;
    EXPECT_EQ(inputError([&] { loadScene(scene, watched()); }), expected);
    EXPECT_EQ(triangles(), (std::vector<size_t>{1}));
}

TEST_F(PartialLoadTest, WhatTheWatcherThrowsEndsTheLoad) {
    const std::string scene = writeScene();
    ThreadPool threads(4);
    for (Executor* executor : {(Executor*) nullptr, (Executor*) &threads}) {
        size_t read = 0;
        LoadOptions options;
        options.executor = executor;
        options.progress = [&](size_t done, size_t) { read = done; };
        options.partial.show = [](const LoadedScene&) { throw std::runtime_error("enough"); };
        EXPECT_THROW(loadScene(scene, options), std::runtime_error);
        EXPECT_TRUE(executor || read == 1) << "threads end what they have begun";

        options = watched();
        options.executor = executor;
        options.progress = [](size_t done, size_t) {
            if (done >= 2) throw 7;
        };
        parts_.clear();
        EXPECT_THROW(loadScene(scene, options), int);
        EXPECT_EQ(parts_.size(), 1u);
    }
    LoadOptions options;
    options.executor = &threads;
    EXPECT_EQ(loadScene(scene, options).scene.mesh.triangles.size(), 18u)
        << "and the next is whole";
}

} // namespace
} // namespace dirt
