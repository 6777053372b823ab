#include "core/cost/forecast.h"

#include "backend_cpu/cpu_backend.h"
#include "backend_cpu/thread_pool.h"
#include "core/frame/forwarding_backend.h"
#include "core/frame/renderer.h"
#include "core/io/load.h"
#include "tests/support/golden_scenes.h"
#include "tests/support/random.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include <time.h>

#include <gtest/gtest.h>

namespace dirt {
namespace {

TEST(Forecast, CountsTheRaysAndBytesOfTheFrame) {
    ThreadPool pool(2);
    for (const std::string& name : test::goldenScenes()) {
        SCOPED_TRACE(name);
        const LoadedScene loaded = loadScene(test::goldenFolder() / "scenes" / (name + ".scene"));
        const Scene& scene = loaded.scene;
        RenderSettings settings = test::goldenSettings(loaded, 3);
        CpuBackend backend(pool), other(pool);
        const Forecast forecast = forecastFrame(scene, settings, backend);
        const RenderResult frame = Renderer(scene, settings, other).render();
        EXPECT_NEAR(forecast.rays / (double) frame.counts.rays, 1.0, 0.25);
        EXPECT_NEAR(forecast.shadowRays, (double) frame.counts.shadowRays,
                    0.25 * (double) frame.counts.shadowRays);
        uint64_t bytes = 0;
        for (const BufferSize& buffer : other.memory()) bytes += buffer.bytes;
        EXPECT_EQ(forecast.memory, bytes);
        EXPECT_GE(forecast.frameMs, forecast.buildMs + 3 * forecast.sampleMs);
    }
}

/// Times passes by the processor time of the whole process, which does not count what other
/// programs take meanwhile.
class ProcessorClock final : public ForwardingBackend {
public:
    using ForwardingBackend::ForwardingBackend;

    void beginTimedPass() override { begin_ = now(); }
    void endTimedPass() override { times_.push_back(now() - begin_); }
    std::vector<double> takePassTimes() override { return std::exchange(times_, {}); }

private:
    static double now() {
        timespec time{};
        clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
        return 1e3 * (double) time.tv_sec + 1e-6 * (double) time.tv_nsec;
    }

    double begin_ = 0.0;
    std::vector<double> times_;
};

/// Each pass takes a millisecond.
class PassCounter final : public ForwardingBackend {
public:
    using ForwardingBackend::ForwardingBackend;

    void beginTimedPass() override {}
    void endTimedPass() override { times_.push_back(1.0); }
    std::vector<double> takePassTimes() override { return std::exchange(times_, {}); }

private:
    std::vector<double> times_;
};

/// Of a frame, and of its build and each sample.
struct Times {
    double frame = 1e30, build = 1e30, sample = 1e30;

    void lower(double f, double b, double s) {
        frame = std::min(frame, f);
        build = std::min(build, b);
        sample = std::min(sample, s);
    }
};

/// Holds the forecast to within a quarter of what a frame takes: the least of rounds, as what
/// interferes only adds, in which both are measured in turn by backends that have done nothing yet.
void expectTimesForecast(const Scene& scene, const RenderSettings& settings) {
    SerialExecutor executor; // one thread, whose time is that of the work
    Times taken, said;
    const int rounds = test::cases(4, 10);
    for (int i = 0; i < 2 * rounds; ++i) {
        CpuBackend backend(executor);
        ProcessorClock clocked(backend);
        if (i % 4 == 0 || i % 4 == 3) { // neither is always first
            const Forecast forecast = forecastFrame(scene, settings, clocked);
            said.lower(forecast.frameMs, forecast.buildMs, forecast.sampleMs);
            continue;
        }
        const RenderResult frame = Renderer(scene, settings, clocked).render();
        double all = 0.0, build = 0.0;
        for (const PassTime& pass : frame.passes) all += pass.ms;
        for (const PassTime& pass : frame.build) build += pass.ms;
        taken.lower(all, build, (all - build - frame.passMs("ShadowMap")) / settings.samples);
    }
    EXPECT_NEAR(said.frame / taken.frame, 1.0, 0.25);
    EXPECT_NEAR(said.sample / taken.sample, 1.0, 0.25);
    if (taken.build > 5.0) { // the clock and what memory costs rule shorter ones
        EXPECT_NEAR(said.build / taken.build, 1.0, 0.25);
    }
}

/// What is done once, and what each sample does: the same passes as the whole frame has.
TEST(Forecast, CountsThePassesOfAllSamples) {
    for (const char* name : {"cards_shadow_map.scene", "materials.scene"}) {
        SCOPED_TRACE(name);
        const LoadedScene loaded = loadScene(test::goldenFolder() / "scenes" / name);
        RenderSettings settings = test::goldenSettings(loaded, 5);
        settings.bounces = 3;
        SerialExecutor executor;
        CpuBackend backend(executor), other(executor);
        PassCounter counted(backend), whole(other);
        const Forecast forecast = forecastFrame(loaded.scene, settings, counted);
        const RenderResult frame = Renderer(loaded.scene, settings, whole).render();
        EXPECT_EQ(forecast.frameMs, totalMs(frame.passes));
        EXPECT_EQ(forecast.buildMs, totalMs(frame.build));
        EXPECT_EQ(forecast.sampleMs,
                  (totalMs(frame.passes) - totalMs(frame.build) - frame.passMs("ShadowMap")) / 5);
        EXPECT_GT(forecast.sampleMs, 5.0);
    }
}

/// By the clock, which what else the machine does reads with it: not part of the short suite.
TEST(Forecast, SaysWhatTimeAFrameWillTake) {
    if (!test::fullTests()) GTEST_SKIP() << "by the clock: with DIRT_TEST_FULL=1 alone";
    const std::filesystem::path large = DIRT_SOURCE_DIR "/scenes";
    const std::filesystem::path small = test::goldenFolder() / "scenes";
    struct Case {
        std::filesystem::path scene;
        int tile, bins, bounces;
    };
    std::vector<Case> all{{large / "atrium.scene", 32, 8, 2},
                          {small / "cards_shadow_map.scene", 16, 16, 3},
                          {small / "materials.scene", 4, 4, 2},
                          {small / "materials.scene", 32, 8, 6}};
    if (test::fullTests())
        for (const char* name : {"atrium.scene", "cornell.scene", "hangar.scene"})
            for (const int tile : {4, 16})
                for (const int bounces : {2, 6}) all.push_back({large / name, tile, 8, bounces});
    for (const Case& one : all) {
        SCOPED_TRACE(one.scene.string() + ", tile " + std::to_string(one.tile));
        const LoadedScene loaded = loadScene(one.scene);
        RenderSettings settings = test::goldenSettings(loaded, 2);
        settings.grid.tile = one.tile;
        settings.grid.bins = one.bins;
        settings.bounces = one.bounces;
        expectTimesForecast(loaded.scene, settings);
    }
}

} // namespace
} // namespace dirt
