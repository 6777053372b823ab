// What is told of a pixel that OpenGL has rendered: its rays, its grid, its answers.

#include "backend_cpu/cpu_backend.h"
#include "backend_cpu/thread_pool.h"
#include "backend_gl/gl_backend.h"
#include "core/explain/path_account.h"
#include "core/explain/ray_trail.h"
#include "tests/support/golden_scenes.h"

#include <gtest/gtest.h>

namespace dirt {
namespace {

TEST(GlExplain, TellsTheSameAsTheCpu) {
    const LoadedScene loaded = loadScene(test::goldenFolder() / "scenes" / "materials.scene");
    RenderSettings settings = test::goldenSettings(loaded, 1);
    settings.grid.width = 24;
    settings.grid.height = 12;
    settings.primary = Primary::traced; // whose ties the device's rasterizer decides otherwise
    ThreadPool pool(2);
    CpuBackend cpu(pool);
    GlBackend gl;
    size_t rays = 0;
    for (const size_t pixel : {100u, 130u, 160u}) {
        const PathAccount a = accountOf(loaded.scene, settings, cpu, pixel, 1);
        const PathAccount b = accountOf(loaded.scene, settings, gl, pixel, 1);
        ASSERT_EQ(a.events.size(), b.events.size());
        EXPECT_EQ(a.radiance, b.radiance);
        for (size_t k = 0; k < a.events.size(); ++k) {
            EXPECT_EQ(a.events[k].point.primitive, b.events[k].point.primitive);
            EXPECT_EQ(a.events[k].shadowRay.has_value(), b.events[k].shadowRay.has_value());
            EXPECT_EQ(a.events[k].lit, b.events[k].lit);
            const PathRay& ray = b.events[k].ray;
            if (ray.direction == glm::vec3(0.0f)) continue;
            const RayTrail trail =
                closestTrail(*b.grid, b.geometry, {ray.origin, ray.direction, ray.skip});
            EXPECT_EQ(trail.hit.primitive, b.events[k].hit.primitive);
            EXPECT_EQ(trail.hit.t, b.events[k].hit.t);
            ++rays;
        }
    }
    EXPECT_GT(rays, 5u);
}

} // namespace
} // namespace dirt
