// Whole frames in GLSL: with traced primary rays the CPU's images, bit for bit.

#include "backend_cpu/cpu_backend.h"
#include "backend_cpu/thread_pool.h"
#include "backend_gl/gl_backend.h"
#include "core/frame/renderer.h"
#include "tests/frame/shapes.h"
#include "tests/gl/paths.h"

#include <gtest/gtest.h>

namespace dirt::test {
namespace {

RenderSettings tracedFrame() {
    RenderSettings settings;
    settings.grid.width = 40;
    settings.grid.height = 24;
    settings.samples = 2;
    settings.primary = Primary::traced;
    return settings;
}

/// A light that casts no shadows: the CPU's image, whichever way shadows would be found.
TEST(GlFrames, EqualTheCpusUnderAnOpenLight) {
    ThreadPool pool(2);
    CpuBackend cpu(pool);
    RenderSettings settings = tracedFrame();
    GlBackend gl;
    Scene scene = room();
    const RenderResult shaded = Renderer(scene, settings, cpu).render();
    for (Spotlight& light : scene.lights) light.shadows = false;
    const RenderResult expected = Renderer(scene, settings, cpu).render();
    EXPECT_FALSE(sameRecords("image", shaded.image.pixels, expected.image.pixels));
    for (const auto way : {LightVisibility::traced, LightVisibility::shadowMap}) {
        settings.visibility = way;
        const RenderResult result = Renderer(scene, settings, gl).render();
        EXPECT_TRUE(sameRecords("image", result.image.pixels, expected.image.pixels));
        EXPECT_EQ(result.counts.shadowRays, 0u);
        EXPECT_EQ(result.passMs("ShadowMap"), 0.0);
    }
}

/// A whole frame: with traced primary rays the CPU's image to the bit, from a pool that has to
/// grow.
TEST(GlFrames, EqualTheCpus) {
    GlBackend gl(GlOptions{.poolNodes = 1000});
    ThreadPool pool(2);
    CpuBackend cpu(pool);
    const RenderSettings settings = tracedFrame();
    const Scene scene = room();
    const RenderResult expected = Renderer(scene, settings, cpu).render();
    const RenderResult result = Renderer(scene, settings, gl).render();
    EXPECT_TRUE(sameRecords("image", result.image.pixels, expected.image.pixels));
    // The device's clock: what does most has taken time, and all passes no longer than the frame.
    double sum = 0.0;
    for (const PassTime& pass : result.passes) {
        EXPECT_GE(pass.ms, 0.0) << pass.name;
        sum += pass.ms;
    }
    EXPECT_GT(result.passMs("Trace"), 0.0);
    EXPECT_GT(result.passMs("FillDepth"), 0.0);
    EXPECT_GT(sum, 0.1 * result.frameMs);
    EXPECT_LE(sum, 1.01 * result.frameMs);
    EXPECT_EQ(result.counts.rays, expected.counts.rays);
    EXPECT_EQ(result.counts.hits, expected.counts.hits);
}

} // namespace
} // namespace dirt::test
