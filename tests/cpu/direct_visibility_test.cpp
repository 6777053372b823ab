// DirectVisibility beside traced primary rays: the same bits.

#include "backend_cpu/cpu_backend.h"
#include "backend_cpu/thread_pool.h"
#include "core/frame/renderer.h"
#include "core/path/camera_rays.h"
#include "core/path/sub_pixel.h"
#include "core/trace/intersect.h"
#include "tests/cpu/surface_points.h"
#include "tests/frame/shapes.h"
#include "tests/support/simd_targets.h"
#include "tests/support/small_scenes.h"

#include <gtest/gtest.h>

namespace dirt {
namespace {

/// G[1] of one sample.
std::vector<SurfacePoint> firstPoints(const Scene& scene, RenderSettings settings, Primary primary,
                                      Executor& executor) {
    settings.samples = 1;
    settings.bounces = 1;
    settings.primary = primary;
    CpuBackend backend(executor);
    Renderer(scene, settings, backend).render();
    return backend.paths().next;
}

TEST(DirectVisibility, EqualsTracedPrimaryRays) {
    ThreadPool pool(2);
    test::Random random(1);
    size_t found = 0;
    for (int i = 0; i < test::cases(300, 5000); ++i) {
        RenderSettings settings;
        settings.grid.mode = random.chance(0.5) ? ViewMode::full : ViewMode::single;
        settings.grid.width = random.range(1, 60);
        settings.grid.height = random.range(1, 40);
        settings.seed = (uint32_t) i;
        const test::ViewSet set(settings.grid, Camera{});
        Scene scene = test::sceneOf(test::smallScene(random, set));
        scene.camera.verticalFov = (float) random.pick({1.0, 20.0, 53.0, 90.0, 140.0, 175.0});
        if (random.chance(0.7)) scene.camera.target = test::randomDirection(random);
        if (random.chance(0.7)) scene.camera.up = test::randomDirection(random);
        const auto raster = firstPoints(scene, settings, Primary::raster, pool);
        const auto traced = firstPoints(scene, settings, Primary::traced, pool);
        ASSERT_EQ(test::countDifferent(raster, traced), 0u) << "case " << i;
        found += test::countFound(raster);
    }
    EXPECT_GT(found, 10000u);
}

TEST(DirectVisibility, EqualsTracedRaysThroughEdges) {
    // Edges that pixels' rays meet exactly: with a = 2 d + v and b = 4 d - v, d . (a x b) = 0,
    // which no rounded cross product says.
    ThreadPool pool(2);
    test::Random random(5);
    size_t onEdges = 0;
    for (int i = 0; i < test::cases(100, 3000); ++i) {
        RenderSettings settings;
        settings.grid.width = 16;
        settings.grid.height = 12;
        settings.seed = (uint32_t) i;
        Camera camera;
        camera.eye = glm::vec3(0.0f);
        camera.target = test::randomDirection(random);
        const CameraRays rays(camera, 16, 12, ViewMode::full);
        const glm::vec2 offset = subPixelOffset(0, settings.seed);
        std::vector<Triangle> triangles;
        for (int k = 0; k < 60; ++k) {
            const glm::vec3 d = rays.through((float) random.below(16) + offset.x,
                                             (float) random.below(12) + offset.y)
                                    .direction;
            const glm::vec3 v = glm::round(test::uniformPoint(random, 0x1p19)) * 0x1p-20f;
            const glm::vec3 a = 2.0f * d + v, b = 4.0f * d - v;
            if (glm::dvec3(a) != 2.0 * glm::dvec3(d) + glm::dvec3(v)) continue;
            if (glm::dvec3(b) != 4.0 * glm::dvec3(d) - glm::dvec3(v)) continue;
            triangles.push_back({a, b, test::uniformPoint(random, 4.0)});
            ++onEdges;
        }
        if (triangles.empty()) continue;
        Scene scene = test::sceneOf(triangles);
        scene.camera = camera;
        ASSERT_EQ(test::countDifferent(firstPoints(scene, settings, Primary::raster, pool),
                                       firstPoints(scene, settings, Primary::traced, pool)),
                  0u)
            << "case " << i;
    }
    EXPECT_GT(onEdges, 500u);
}

TEST(DirectVisibility, IsTheSameOnEveryInstructionSet) {
    ThreadPool pool(2);
    test::Random random(6);
    for (int i = 0; i < test::cases(30, 1000); ++i) {
        RenderSettings settings;
        settings.grid.width = random.range(1, 100);
        settings.grid.height = random.range(1, 60);
        settings.seed = (uint32_t) i;
        Scene scene = test::sceneOf(test::smallScene(random, {settings.grid, Camera{}}));
        scene.camera.target = test::randomDirection(random);
        const auto traced = firstPoints(scene, settings, Primary::traced, pool);
        test::forEachTarget([&] {
            const auto raster = firstPoints(scene, settings, Primary::raster, pool);
            ASSERT_EQ(test::countDifferent(raster, traced), 0u) << "case " << i;
        });
    }
}

TEST(DirectVisibility, OrdersSheetsThatNearlyCoincide) {
    // Large triangles over the whole image, apart by some roundings or crossing each other: which
    // is nearest changes from pixel to pixel, and only exact t tells.
    ThreadPool pool(2);
    test::Random random(7);
    for (int i = 0; i < test::cases(60, 3000); ++i) {
        RenderSettings settings;
        settings.grid.width = 40;
        settings.grid.height = 30;
        settings.seed = (uint32_t) i;
        const double apart = std::pow(10.0, random.uniform(-8, -1));
        // Walls across the view, or floors just below the eye, along no axis.
        Camera camera;
        camera.eye = glm::vec3(0.0f);
        camera.target = test::randomDirection(random);
        camera.up = test::randomDirection(random);
        const CameraBasis basis = cameraBasis(camera);
        const bool wall = random.chance(0.5);
        const double height = wall ? 1.0 : std::pow(10.0, random.uniform(-4, -1));
        std::vector<Triangle> triangles;
        for (int k = 0; k < 24; ++k) {
            const auto corner = [&](float x, float y) {
                const float at = (float) (-height * (1.0 + apart * random.uniform(-1, 1)));
                const glm::vec3 p = wall ? glm::vec3(x, y, at) : glm::vec3(x, at, -2 - y);
                return p.x * basis.right - p.y * basis.down - p.z * basis.forward;
            };
            triangles.push_back({corner(-4, -2), corner(4, -2), corner(0, 6)});
        }
        Scene scene = test::sceneOf(triangles);
        scene.camera = camera;
        const auto raster = firstPoints(scene, settings, Primary::raster, pool);
        ASSERT_GT(test::countFound(raster), raster.size() / 4);
        ASSERT_EQ(test::countDifferent(raster, firstPoints(scene, settings, Primary::traced, pool)),
                  0u)
            << "case " << i;
    }
}

TEST(DirectVisibility, CoincidentTrianglesShowTheLowestId) {
    test::Random random(2);
    std::vector<Triangle> triangles;
    test::addRoom(random, triangles);
    const std::vector<Triangle> once = triangles;
    for (int copy = 0; copy < 3; ++copy)
        for (const Triangle& t : once) triangles.push_back({t.c, t.a, t.b});
    RenderSettings settings;
    settings.grid.width = 64;
    settings.grid.height = 48;
    for (unsigned threads : {1u, 2u, 5u}) {
        ThreadPool pool(threads);
        for (const SurfacePoint& point :
             firstPoints(test::sceneOf(triangles), settings, Primary::raster, pool))
            ASSERT_LT(point.primitive, once.size());
    }
}

} // namespace
} // namespace dirt
