// dirt check, the OpenGL backend against the CPU's, on whole scenes and over all settings that
// shape the passes: cornell over the full product of what shapes the structure, the others over a
// set in which every pair of settings occurs. The suite takes a few of them, on small images.

#include "backend_cpu/cpu_backend.h"
#include "backend_cpu/thread_pool.h"
#include "backend_gl/gl_backend.h"
#include "core/check/check.h"
#include "tests/support/covering.h"
#include "tests/support/random.h"
#include "tests/verify/places.h"

#include <iostream>

#include <gtest/gtest.h>

namespace dirt::test {
namespace {

const std::vector<int> kTiles{1, 4, 16, 64}, kBins{1, 16, 44};

/// 512x512, 1024x512 and 333x217; in the suite a sixteenth of that, as a software driver is slow.
std::pair<int, int> sizeOf(int index) {
    const std::pair<int, int> full[] = {{512, 512}, {1024, 512}, {333, 217}};
    const std::pair<int, int> cut[] = {{32, 32}, {48, 24}, {21, 13}};
    return fullTests() ? full[index] : cut[index];
}

/// Of tile, bins, size and view.
RenderSettings structureOf(const Choice& choice) {
    RenderSettings settings;
    settings.grid.tile = kTiles[(size_t) choice[0]];
    settings.grid.bins = kBins[(size_t) choice[1]];
    std::tie(settings.grid.width, settings.grid.height) = sizeOf(choice[2]);
    settings.grid.mode = choice[3] == 0 ? ViewMode::full : ViewMode::single;
    settings.bounces = 2;
    return settings;
}

/// Also of fetch, primary rays and traversal.
RenderSettings settingsOf(const Choice& choice) {
    RenderSettings settings = structureOf(choice);
    settings.fetch = choice[4] == 0 ? Fetch::raster : Fetch::direct;
    settings.primary = choice[5] == 0 ? Primary::raster : Primary::traced;
    settings.grid.traversal = choice[6] == 0 ? Traversal::hierarchical : Traversal::linear;
    settings.grid.maxMip = choice[7] == 0 ? -1 : 1;
    return settings;
}

std::string text(const RenderSettings& settings) {
    const GridSettings& grid = settings.grid;
    return "--size " + std::to_string(grid.width) + "x" + std::to_string(grid.height) + " --tile " +
           std::to_string(grid.tile) + " --bins " + std::to_string(grid.bins) +
           (grid.mode == ViewMode::full ? " --view full" : " --view single") +
           (settings.fetch == Fetch::raster ? " --fetch raster" : " --fetch direct") +
           (settings.primary == Primary::raster ? " --primary raster" : " --primary traced") +
           (grid.traversal == Traversal::linear ? " --traversal linear" : "") +
           (grid.maxMip < 0 ? "" : " --max-mip " + std::to_string(grid.maxMip)) + " --bounces " +
           std::to_string(settings.bounces);
}

class CheckScenes : public testing::Test {
protected:
    /// Everything equal, and of direct visibility only what is tolerated.
    void expectEqual(const Scene& scene, const RenderSettings& settings) {
        SCOPED_TRACE(text(settings));
        const CheckReport report = checkBackends(scene, settings, cpu_, gl_);
        EXPECT_TRUE(report.passed());
        for (const CheckRow& row : report.rows) {
            EXPECT_EQ(row.different, 0u)
                << row.pass << " " << row.event << ", " << row.buffer << ", " << row.tested
                << " on " << row.source << ": " << (row.examples.empty() ? "" : row.examples[0]);
            if (row.pass == "DirectVisibility") {
                tolerated_ += row.withinTolerance;
                seen_ += row.compared;
            } else {
                EXPECT_EQ(row.withinTolerance, 0u) << row.pass << ", " << row.buffer;
            }
        }
        ++checks_;
    }

    /// A covering set; in the suite, only what it has for \p view with rasterized primary rays, at
    /// most \p most.
    void expectEqualOverSettings(const std::string& name, ViewMode view, uint64_t most) {
        for (const Place& place : places()) {
            if (place.name != name) continue;
            std::optional<Scene> scene = loadPlace(place, cases(10'000, 300'000));
            if (!scene) GTEST_SKIP() << place.file << " is not in " << scenesFolder();
            Spotlight light;
            light.position = place.eye + 0.125f * (place.target - place.eye) + 0.0625f * place.up;
            light.target = place.target;
            light.aperture = 120.0f;
            light.penumbra = 60.0f;
            scene->lights = {light};
            scene->background = glm::vec3(0.5f);
            const auto choices = pairwiseCovering({4, 3, 3, 2, 2, 2, 2, 2});
            EXPECT_LE(choices.size(), 16u);
            for (const Choice& choice : choices) {
                const RenderSettings settings = settingsOf(choice);
                if (!fullTests() && (settings.grid.mode != view || checks_ == most ||
                                     settings.primary != Primary::raster))
                    continue;
                expectEqual(*scene, settings);
            }
        }
    }

    void TearDown() override {
        if (checks_ > 0)
            std::cout << checks_ << " checks; of " << seen_ << " pixels' direct visibility "
                      << tolerated_ << " within tolerance\n";
    }

    ThreadPool pool_;
    CpuBackend cpu_{pool_};
    GlBackend gl_{GlOptions{.poolNodes = 1000}}; // and has to grow
    uint64_t checks_ = 0, tolerated_ = 0, seen_ = 0;
};

TEST_F(CheckScenes, Cornell) {
    const TemporaryFolder folder;
    generateScene("cornell", 36, folder.path());
    const Scene scene = loadScene(folder / "cornell.scene", {}).scene;
    const auto choices = fullTests() ? fullProduct({4, 3, 3, 2}) : pairwiseCovering({4, 3, 3, 2});
    for (size_t i = 0; i < choices.size(); i += fullTests() ? 1 : 6)
        expectEqual(scene, structureOf(choices[i]));
}

TEST_F(CheckScenes, Atrium) {
    expectEqualOverSettings("atrium", ViewMode::full, 1);
}
// A software driver takes a minute and more for a sample of these.
TEST_F(CheckScenes, Sponza) {
    if (!fullTests()) GTEST_SKIP() << "long form only";
    expectEqualOverSettings("sponza", ViewMode::single, 1);
}
TEST_F(CheckScenes, Conference) {
    if (!fullTests()) GTEST_SKIP() << "long form only";
    expectEqualOverSettings("conference", ViewMode::single, 1);
}

/// Of what the sets promise.
TEST(Covering, HoldsEveryPair) {
    const std::vector<int> values{4, 3, 3, 2, 2, 2, 2, 2};
    std::set<std::pair<std::pair<int, int>, std::pair<int, int>>> covered;
    for (const Choice& choice : pairwiseCovering(values)) covered.merge(pairsOf(choice));
    size_t pairs = 0;
    for (size_t i = 0; i < values.size(); ++i)
        for (size_t j = i + 1; j < values.size(); ++j) pairs += (size_t) (values[i] * values[j]);
    EXPECT_EQ(covered.size(), pairs);
}

} // namespace
} // namespace dirt::test
