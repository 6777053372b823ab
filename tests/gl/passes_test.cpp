// Each pass of a sample in GLSL against the CPU's on the same data, bit for bit: what it writes,
// and that it leaves everything else as it was.

#include "backend_cpu/cpu_backend.h"
#include "backend_cpu/thread_pool.h"
#include "backend_gl/gl_backend.h"
#include "tests/frame/shapes.h"
#include "tests/gl/paths.h"
#include "tests/support/print.h"
#include "tests/support/small_scenes.h"

#include <functional>

#include <gtest/gtest.h>

namespace dirt::test {
namespace {

/// Runs the passes of samples on both backends, each pass of both on what the CPU had before it.
class BothBackends {
public:
    BothBackends(const Scene& scene, const RenderSettings& settings, GlBackend& gl,
                 Executor& executor)
        : cpu_(executor), gl_(gl), settings_(settings) {
        need_ = requirementsOf(scene, settings, true);
        for (Backend* backend : {(Backend*) &cpu_, (Backend*) &gl_}) {
            backend->build(scene.mesh, scene.camera, settings.grid);
            backend->beginFrame(scene, settings, need_);
        }
        EXPECT_TRUE(samePaths(gl_.readPaths(), cpu_.readPaths())) << "beginFrame";
    }

    void sample(uint32_t index) {
        pass("beginSample", [](Backend& b) { b.beginSample(); });
        for (int k = 0; k < settings_.bounces; ++k) {
            if (k > 0) pass("DepthMask", [k](Backend& b) { b.depthMask(k); });
            if (k == 0 && !need_.tracedPrimary) {
                cpu_.directVisibility(index); // its own test is below
            } else {
                pass("Rays", [&](Backend& b) { b.rays(index, k); });
                pass("Trace", [k](Backend& b) { b.trace(k); });
                pass("Fetch", [k](Backend& b) { b.fetch(k); });
            }
            pass("Visibility", [k](Backend& b) { b.visibility(k); });
            pass("Shade", [k](Backend& b) { b.shade(k); });
            pass("shift", [](Backend& b) { b.shift(); });
        }
        pass("Resolve", [](Backend& b) { b.resolve(); });
    }

    size_t hits = 0; ///< that were compared

private:
    void pass(const char* name, const std::function<void(Backend&)>& run) {
        gl_.writePaths(cpu_.readPaths());
        const FrameCounts cpuBefore = cpu_.counts(), glBefore = gl_.counts();
        run(cpu_);
        run(gl_);
        ASSERT_TRUE(samePaths(gl_.readPaths(), cpu_.readPaths())) << name;
        const auto since = [](const FrameCounts& now, const FrameCounts& then) {
            return std::array{now.rays - then.rays, now.hits - then.hits,
                              now.shadowRays - then.shadowRays};
        };
        ASSERT_EQ(since(gl_.counts(), glBefore), since(cpu_.counts(), cpuBefore)) << name;
        if (std::string(name) != "Trace") return;
        for (const Hit& hit : cpu_.paths().hits) hits += hit.found();
    }

    CpuBackend cpu_;
    GlBackend& gl_;
    RenderSettings settings_;
    Requirements need_;
};

RenderSettings randomSettings(Random& random) {
    RenderSettings settings;
    settings.grid.mode = random.chance(0.5) ? ViewMode::full : ViewMode::single;
    settings.grid.width = random.range(1, 40);
    settings.grid.height = random.range(1, 30);
    settings.grid.tile = random.pick({1, 2, 4, 7, 16, 64});
    settings.grid.bins = random.pick({1, 16, 44});
    settings.grid.traversal = random.chance(0.3) ? Traversal::linear : Traversal::hierarchical;
    settings.bounces = 3;
    settings.primary = random.chance(0.7) ? Primary::traced : Primary::raster;
    settings.fetch = random.chance(0.6) ? Fetch::raster : Fetch::direct;
    settings.seed = (uint32_t) random.below(1000);
    return settings;
}

TEST(GlPasses, EqualTheCpusOnARoom) {
    GlBackend gl;
    ThreadPool pool(2);
    for (const ViewMode mode : {ViewMode::full, ViewMode::single})
        for (const Fetch fetch : {Fetch::raster, Fetch::direct}) {
            RenderSettings settings;
            settings.grid.mode = mode;
            settings.grid.width = 53;
            settings.grid.height = 31;
            settings.fetch = fetch;
            settings.primary = fetch == Fetch::raster ? Primary::traced : Primary::raster;
            const Scene scene = room();
            BothBackends both(scene, settings, gl, pool);
            both.sample(0);
            both.sample(5);
            ASSERT_FALSE(HasFailure()) << "mode " << (int) mode << " fetch " << (int) fetch;
            EXPECT_GT(both.hits, 1000u);
        }
}

TEST(GlPasses, EqualTheCpusOnSmallScenes) {
    GlBackend gl;
    ThreadPool pool(2);
    Random random(3);
    for (int i = 0; i < cases(12, 600); ++i) {
        const RenderSettings settings = randomSettings(random);
        const ViewSet set(settings.grid, Camera{});
        Scene scene = sceneOf(smallScene(random, set));
        scene.background = {0.1f, 0.2f, 0.3f};
        if (random.chance(0.7)) {
            Spotlight light;
            light.position = uniformPoint(random, 1.0);
            light.target = uniformPoint(random, 1.0);
            light.conical = random.chance(0.7);
            light.exponent = random.pick({1.0f, 3.0f});
            scene.lights = {light};
        }
        BothBackends both(scene, settings, gl, pool);
        both.sample((uint32_t) i);
        ASSERT_FALSE(HasFailure()) << "case " << i << ", " << describe(set);
    }
}

} // namespace
} // namespace dirt::test
