// Parts of a scene that are drawn while others are read: on whose thread, how often, and what ends
// it.

#include "app/viewer/scene_loading.h"

#include "core/base/error.h"
#include "tests/support/temporary_folder.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace dirt {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

class SceneLoadingTest : public testing::Test {
protected:
    static constexpr size_t kObjects = 12;

    /// Of objects of a triangle each, which one thread reads.
    SceneLoadingTest() {
        std::string scene = "<world><user position='0 0 5' lookat='0 0 0'/>";
        for (size_t i = 0; i < kObjects; ++i) {
            const std::string name = "o" + std::to_string(i) + ".obj";
            folder_.write(name, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
            scene += "<object file='" + name + "'/>";
        }
        options_.scene = folder_.write("a.scene", scene + "</world>");
        options_.size = ImageSize{48, 32};
        options_.threads = 1;
        options_.quiet = options_.noCache = true;
    }

    static size_t trianglesOf(const Input& input) { return input.scene.mesh.triangles.size(); }

    test::TemporaryFolder folder_;
    CommonOptions options_;
};

TEST_F(SceneLoadingTest, PartsAreDrawnWhileOthersAreRead) {
    std::atomic<int> drawn{0};
    std::vector<size_t> triangles;
    const auto caller = std::this_thread::get_id();
    LoadingWatch watch;
    watch.progress = [&](size_t done, size_t of) {
        EXPECT_NE(std::this_thread::get_id(), caller);
        EXPECT_EQ(of, kObjects);
        // At the second, that of the first is waited for: reading goes on beside it.
        if (done == 1 || done == kObjects - 2) std::this_thread::sleep_for(milliseconds(150));
        while (drawn < (done < 2 ? 0 : done < kObjects - 1 ? 1 : 2))
            std::this_thread::sleep_for(milliseconds(1));
    };
    watch.draw = [&](const Input& part, const std::function<bool()>& isOver) {
        EXPECT_EQ(std::this_thread::get_id(), caller);
        EXPECT_FALSE(isOver());
        EXPECT_EQ(part.scene.camera.eye, glm::vec3(0, 0, 5));
        EXPECT_EQ(part.settings.grid.width, 48);
        triangles.push_back(trianglesOf(part));
        ++drawn;
    };
    const Input all = openWatched(options_, watch);
    EXPECT_EQ(trianglesOf(all), kObjects);
    ASSERT_GE(triangles.size(), 2u);
    EXPECT_EQ(triangles[0], 1u);
    EXPECT_GT(triangles[1], 1u);
    EXPECT_LT(triangles[1], kObjects);
}

/// Pictures take no more than a third of the time, however long each takes.
TEST_F(SceneLoadingTest, ReadingTakesMostOfTheTime) {
    Clock::time_point ended{};
    Clock::duration cost{};
    int drawn = 0;
    LoadingWatch watch;
    watch.progress = [](size_t, size_t) { std::this_thread::sleep_for(milliseconds(80)); };
    watch.draw = [&](const Input&, const std::function<bool()>&) {
        const auto begin = Clock::now();
        EXPECT_TRUE(drawn++ == 0 || begin - ended >= 2 * cost);
        std::this_thread::sleep_for(milliseconds(100));
        ended = Clock::now(), cost = ended - begin;
    };
    openWatched(options_, watch);
    EXPECT_GT(drawn, 0);
}

TEST_F(SceneLoadingTest, WhatIsThereSoonIsNotDrawnInParts) {
    LoadingWatch watch;
    const auto start = Clock::now();
    Clock::duration soonest = Clock::duration::max();
    watch.draw = [&](const Input&, const std::function<bool()>&) {
        soonest = std::min(soonest, Clock::now() - start);
    };
    openWatched(options_, watch);
    EXPECT_GE(soonest, milliseconds(100)); // of none, or on a machine that is busy
}

TEST_F(SceneLoadingTest, APictureIsGivenUpWhenAllIsThere) {
    LoadingWatch watch;
    std::atomic<bool> begun{false};
    watch.progress = [&](size_t done, size_t) {
        if (done == 1) std::this_thread::sleep_for(milliseconds(150));
        while (done == 2 && !begun) std::this_thread::sleep_for(milliseconds(1));
    };
    bool given = false;
    watch.draw = [&](const Input&, const std::function<bool()>& isOver) {
        begun = true;
        while (!isOver()) std::this_thread::sleep_for(milliseconds(1));
        given = true;
    };
    EXPECT_EQ(trianglesOf(openWatched(options_, watch)), kObjects);
    EXPECT_TRUE(given);
}

TEST_F(SceneLoadingTest, WhatDrawingThrowsEndsTheDrawingAlone) {
    LoadingWatch watch;
    watch.progress = [](size_t, size_t) { std::this_thread::sleep_for(milliseconds(60)); };
    int drawn = 0;
    watch.draw = [&](const Input&, const std::function<bool()>&) {
        ++drawn;
        throw std::runtime_error("no memory");
    };
    EXPECT_EQ(trianglesOf(openWatched(options_, watch)), kObjects);
    EXPECT_EQ(drawn, 1);
}

TEST_F(SceneLoadingTest, WhatProgressThrowsEndsTheLoading) {
    for (const bool draws : {false, true}) {
        LoadingWatch watch;
        size_t read = 0;
        watch.progress = [&](size_t done, size_t) {
            read = done;
            if (done == 3) throw 7;
        };
        if (draws) watch.draw = [](const Input&, const std::function<bool()>&) {};
        EXPECT_THROW(openWatched(options_, watch), int);
        EXPECT_EQ(read, 3u);
    }
}

TEST_F(SceneLoadingTest, ErrorsAreThoseOfTheLoad) {
    folder_.write("o5.obj", "f 1 2 3\n");
    LoadingWatch watch;
    watch.draw = [](const Input&, const std::function<bool()>&) {};
    EXPECT_THROW(openWatched(options_, watch), InputError);
}

TEST(LoadingText, SaysHowFarItIsWhenThatIsKnown) {
    EXPECT_EQ(loadingText("a.scene", {}), "loading a.scene");
    EXPECT_EQ(loadingText("a.scene", {3, 12}), "loading a.scene: 3 of 12 files");
}

} // namespace
} // namespace dirt
