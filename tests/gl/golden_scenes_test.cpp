// The golden scenes under OpenGL: with traced primary rays the CPU's image, to the bit.

#include "backend_cpu/cpu_backend.h"
#include "backend_cpu/thread_pool.h"
#include "backend_gl/gl_backend.h"
#include "core/frame/renderer.h"
#include "tests/gl/paths.h"
#include "tests/support/golden_scenes.h"
#include "tests/support/random.h"

#include <algorithm>

namespace dirt::test {
namespace {

TEST(GoldenScenes, HaveTheCpusImage) {
    ThreadPool pool(2);
    CpuBackend cpu(pool);
    GlBackend gl;
    for (const std::string& name : goldenScenes()) {
        SCOPED_TRACE(name);
        const LoadedScene loaded =
            loadScene((goldenFolder() / "scenes" / (name + ".scene")).string(), {});
        Scene scene = loaded.scene;
        for (Spotlight& light : scene.lights) light.resolution = std::min(light.resolution, 100);
        RenderSettings settings = goldenSettings(loaded, cases(1, 8));
        settings.grid.width = cases(48, 192);
        settings.grid.height = cases(24, 96);
        settings.primary = Primary::traced;
        const RenderResult expected = Renderer(scene, settings, cpu).render();
        const RenderResult found = Renderer(scene, settings, gl).render();
        EXPECT_TRUE(sameRecords("image", found.image.pixels, expected.image.pixels));
        EXPECT_EQ(found.counts.rays, expected.counts.rays);
        EXPECT_EQ(found.counts.hits, expected.counts.hits);
        EXPECT_EQ(found.counts.shadowRays, expected.counts.shadowRays);
    }
}

} // namespace
} // namespace dirt::test
