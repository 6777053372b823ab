// Fetch by rasterization beside Fetch by primitive id: the same bits.

#include "backend_cpu/cpu_backend.h"
#include "backend_cpu/thread_pool.h"
#include "core/frame/renderer.h"
#include "core/path/fetch_surface.h"
#include "tests/cpu/surface_points.h"
#include "tests/frame/shapes.h"
#include "tests/support/simd_targets.h"
#include "tests/support/small_scenes.h"

#include <gtest/gtest.h>

namespace dirt {
namespace {

/// Runs a frame with raster fetch, and in each event the direct fetch after it.
void expectSameFetches(const Scene& scene, RenderSettings settings, Executor& executor,
                       size_t& records) {
    settings.samples = 1;
    settings.primary = Primary::traced;
    settings.fetch = Fetch::raster;
    CpuBackend backend(executor);
    RenderHooks hooks;
    hooks.observe = [&](uint32_t, int event) {
        PathBuffers paths = backend.readPaths();
        const std::vector<SurfacePoint> raster = paths.next;
        size_t missed = 0, repeated = 0;
        for (Hit& hit : paths.hits) {
            if (!hit.found()) continue;
            ++records;
            missed += hit.fetches == 0;
            repeated += hit.fetches > 1;
        }
        EXPECT_EQ(missed, 0u);
        EXPECT_EQ(repeated, 0u);
        const FrameGeometry geometry = backend.readGeometry();
        const Requirements need = requirementsOf(scene, settings, true);
        passFetch(FrameContext(scene, geometry, settings, need), executor, paths);
        EXPECT_EQ(test::countDifferent(raster, paths.next), 0u) << "event " << event;
    };
    Renderer(scene, settings, backend).render(hooks);
}

TEST(RasterFetch, FindsEveryRecordOnceAndEqualsFetchById) {
    test::Random random(4);
    size_t records = 0;
    for (int i = 0; i < test::cases(150, 3000); ++i) {
        RenderSettings settings;
        settings.grid.mode = random.chance(0.5) ? ViewMode::full : ViewMode::single;
        settings.grid.width = random.range(1, 80);
        settings.grid.height = random.range(1, 50);
        settings.grid.tile = random.pick({1, 2, 4, 7, 16, 64});
        settings.grid.bins = random.pick({1, 16, 44});
        settings.bounces = 4;
        settings.seed = (uint32_t) i;
        const test::ViewSet set(settings.grid, Camera{});
        Scene scene = test::sceneOf(test::smallScene(random, set));
        scene.camera.target = test::randomDirection(random);
        ThreadPool pool(random.pick({1u, 2u, 7u}));
        expectSameFetches(scene, settings, pool, records);
        ASSERT_FALSE(HasFailure()) << "case " << i;
    }
    EXPECT_GT(records, 100'000u);

    for (int tile : {1, 16, 64}) {
        RenderSettings settings;
        settings.grid.width = 97;
        settings.grid.height = 61;
        settings.grid.tile = tile;
        ThreadPool pool(2);
        expectSameFetches(test::room(), settings, pool, records);
    }
}

TEST(RasterFetch, FindsEveryRecordOnEveryInstructionSet) {
    ThreadPool pool(2);
    test::Random random(8);
    size_t records = 0;
    for (int i = 0; i < test::cases(10, 300); ++i) {
        RenderSettings settings;
        settings.grid.width = random.range(1, 60);
        settings.grid.height = random.range(1, 40);
        settings.grid.tile = random.pick({1, 7, 16});
        const Scene scene =
            test::sceneOf(test::smallScene(random, test::ViewSet(settings.grid, Camera{})));
        test::forEachTarget([&] { expectSameFetches(scene, settings, pool, records); });
        ASSERT_FALSE(HasFailure()) << "case " << i;
    }
    EXPECT_GT(records, 10'000u);
}

TEST(RasterFetch, FindsRecordsOfMoreNeighboursThanItRasterizesAtOnce) {
    // Of so many triangles a bucket has 2048, and all of one are seen.
    std::vector<Triangle> triangles(300'000, Triangle{{0, 0, 1}, {1, 0, 1}, {0, 0, 1}});
    for (int i = 0; i < 1024; ++i) {
        const float x = (float) (i % 32 - 16), y = (float) (i / 32 - 16);
        triangles[4096 + 2 * i] = {{x, y, -20}, {x + 1, y, -20}, {x, y + 1, -20}};
        triangles[4097 + 2 * i] = {{x + 1, y, -20}, {x + 1, y + 1, -20}, {x, y + 1, -20}};
    }
    RenderSettings settings;
    settings.grid.width = settings.grid.height = 150;
    settings.bounces = 1;
    ThreadPool pool(2);
    Scene scene = test::sceneOf(triangles);
    scene.camera.verticalFov = 80.0f;
    size_t records = 0;
    expectSameFetches(scene, settings, pool, records);
    EXPECT_GT(records, 20'000u);
}

TEST(RasterFetch, LeavesRecordsListedWhereTheirTriangleIsNot) {
    // Two triangles, apart, which are neighbours among many; records of the one moved to where the
    // other is, or to the eye.
    std::vector<Triangle> triangles(600, Triangle{{0, 0, 9}, {1, 0, 9}, {0, 0, 9}});
    triangles[0] = {{-4, -2, -5}, {-2, -2, -5}, {-3, 2, -5}};
    triangles[1] = {{4, -2, -5}, {2, -2, -5}, {3, 2, -5}};
    RenderSettings settings;
    settings.grid.width = 80;
    settings.grid.height = 40;
    settings.grid.tile = 4;
    settings.bounces = settings.samples = 1;
    settings.primary = Primary::traced;
    SerialExecutor serial;
    CpuBackend backend(serial);
    size_t moved = 0, stayed = 0;
    RenderHooks hooks;
    hooks.observe = [&](uint32_t, int event) {
        PathBuffers paths = backend.readPaths();
        std::vector<SurfacePoint> expected = paths.next;
        const auto other = std::find_if(paths.hits.begin(), paths.hits.end(),
                                        [](const Hit& hit) { return hit.primitive == 0; });
        ASSERT_NE(other, paths.hits.end());
        for (size_t pixel = 0; pixel < paths.hits.size(); ++pixel) {
            Hit& hit = paths.hits[pixel];
            hit.fetches = 0;
            if (hit.primitive != 1 || pixel % 3 == 0) continue;
            hit.view = pixel % 3 == 1 ? other->view : 6;
            hit.tile = pixel % 3 == 1 ? other->tile : 0;
            expected[pixel] = {};
        }
        backend.writePaths(paths);
        backend.fetch(event);
        const PathBuffers after = backend.readPaths();
        EXPECT_EQ(test::countDifferent(after.next, expected), 0u);
        for (size_t pixel = 0; pixel < after.hits.size(); ++pixel) {
            if (!after.hits[pixel].found()) continue;
            const bool stays = expected[pixel].found();
            EXPECT_EQ(after.hits[pixel].fetches, stays ? 1u : 0u);
            ++(stays ? stayed : moved);
        }
    };
    Renderer(test::sceneOf(triangles), settings, backend).render(hooks);
    EXPECT_GT(moved, 50u);
    EXPECT_GT(stayed, 50u);
}

/// A triangle through the eye is in the tiles around its own plane only. Rays from elsewhere
/// through the eye hit it in none of them; rays from the eye do not see it.
TEST(RasterFetch, FindsTrianglesThatHoldTheEye) {
    const Triangle triangle{{-1, -0.3f, -1}, {1, -0.3f, -1}, {0, 0.6f, 2}};
    const Scene scene = test::sceneOf({triangle});
    const glm::dvec3 n =
        glm::cross(glm::dvec3(triangle.b - triangle.a), glm::dvec3(triangle.c - triangle.a));
    ASSERT_EQ(glm::dot(n, glm::dvec3(triangle.a)), 0.0) << "the origin is in the triangle's plane";
    RenderSettings settings;
    settings.grid.width = settings.grid.height = 33;
    settings.grid.tile = 4;
    settings.bounces = 1;
    settings.primary = Primary::traced;
    SerialExecutor serial;
    CpuBackend backend(serial);
    RenderHooks hooks;
    hooks.observe = [&](uint32_t, int event) {
        PathBuffers paths = backend.readPaths();
        for (const Hit& hit : paths.hits) EXPECT_FALSE(hit.found());
        for (size_t i = 0; i < paths.rays.size(); ++i) {
            const glm::vec3 from(0.25f * (float) (i % 33) - 4.0f, 3.0f, 0.125f * (float) (i / 33));
            paths.rays[i].origin = from;
            paths.rays[i].direction = -from;
        }
        backend.writePaths(paths);
        backend.trace(event);
        backend.fetch(event);
        const PathBuffers after = backend.readPaths();
        const FrameGeometry geometry = backend.readGeometry();
        std::vector<SurfacePoint> expected(after.next.size());
        for (size_t i = 0; i < expected.size(); ++i) {
            const Hit& hit = after.hits[i];
            ASSERT_TRUE(hit.found());
            EXPECT_EQ(hit.view, 6u) << "the eye itself";
            EXPECT_EQ(hit.fetches, 1u);
            expected[i] =
                fetchSurface(scene, geometry, after.rays[i].direction, hit.primitive, hit.u, hit.v);
        }
        EXPECT_EQ(test::countDifferent(after.next, expected), 0u);
    };
    Renderer(scene, settings, backend).render(hooks);
}

} // namespace
} // namespace dirt
