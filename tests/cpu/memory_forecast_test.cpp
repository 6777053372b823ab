// A frame allocates about as much as is forecast: never twice as much, and not below the half.

#include "backend_cpu/memory_forecast.h"

#include "backend_cpu/cpu_backend.h"
#include "backend_cpu/thread_pool.h"
#include "core/frame/renderer.h"
#include "tests/frame/shapes.h"
#include "tests/support/counted_memory.h"
#include "tests/support/random.h"

#include <gtest/gtest.h>

namespace dirt::test {
namespace {

/// A lit room with balls in it.
Scene ballRoom(int balls, int rings) {
    Scene scene;
    scene.materials = {Material()};
    addBox(scene.mesh, {-4, -4, -4}, {4, 4, 4}, 0);
    Random random(7);
    const auto place = [&random] { return (float) random.uniform(-3.0, 3.0); };
    for (int i = 0; i < balls; ++i)
        addSphere(scene.mesh, {place(), place(), place()}, 0.4f, rings, false, 0);
    scene.camera.eye = {0.1f, 0.2f, 3.5f};
    scene.camera.target = {0, 0, 0};
    Spotlight light;
    light.position = {0.0f, 3.0f, 0.0f};
    light.target = {0.1f, -1.0f, 0.0f};
    light.aperture = 150.0f;
    light.flux = 100.0f;
    scene.lights = {light};
    return scene;
}

struct Case {
    const char* name;
    int balls, rings, width, height, tile, bins, viewSize;
};

void PrintTo(const Case& c, std::ostream* out) {
    *out << c.name;
}

class Forecast : public testing::TestWithParam<Case> {};

TEST_P(Forecast, IsWhatAFrameTakes) {
    const Case& c = GetParam();
    const Scene scene = ballRoom(c.balls, c.rings);
    RenderSettings settings;
    settings.grid.width = c.width;
    settings.grid.height = c.height;
    settings.grid.tile = c.tile;
    settings.grid.bins = c.bins;
    settings.grid.viewSize = c.viewSize;
    settings.samples = 1;
    ThreadPool pool(2);
    const Footprint footprint(scene.mesh, scene.camera, settings.grid, pool);
    const MemoryForecast forecast = forecastMemory(footprint, scene.mesh.triangles.size(), settings,
                                                   requirementsOf(scene, settings, true));
    const double peak = (double) peakOf([&] {
        CpuBackend backend(pool);
        Renderer(scene, settings, backend).render();
    });
    RecordProperty("peak", std::to_string(peak / 1e6));
    std::printf("%s: %.1f MB, forecast %.1f: structure %.1f, geometry %.1f, paths %.1f\n", c.name,
                peak / 1e6, (double) forecast.total() / 1e6, (double) forecast.structure / 1e6,
                (double) forecast.geometry / 1e6, (double) forecast.paths / 1e6);
    EXPECT_LT(peak, 1.25 * (double) forecast.total());
    EXPECT_GT(peak, 0.5 * (double) forecast.total());
}

INSTANTIATE_TEST_SUITE_P(All, Forecast,
                         testing::Values(Case{"pixels", 1, 8, 512, 256, 32, 4, 0},
                                         Case{"triangles", 100, 32, 64, 64, 16, 16, 512},
                                         Case{"tiles", 1, 8, 64, 64, 1, 4, 512},
                                         Case{"bins", 2, 8, 64, 64, 2, 64, 256},
                                         Case{"lists", 100, 24, 64, 64, 4, 16, 512}));

} // namespace
} // namespace dirt::test
