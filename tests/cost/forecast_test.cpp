#include "core/cost/forecast.h"

#include "backend_cpu/cpu_backend.h"
#include "backend_cpu/thread_pool.h"
#include "core/frame/renderer.h"
#include "core/io/load.h"
#include "tests/support/golden_scenes.h"

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
        for (const BufferSize& buffer : other.memory()) bytes += buffer.second;
        EXPECT_EQ(forecast.memory, bytes);
        EXPECT_EQ(forecast.frameMs, forecast.buildMs + 3 * forecast.sampleMs);
    }
}

} // namespace
} // namespace dirt
