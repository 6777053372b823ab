// The passes that rasterize, beside what they stand in for: DirectVisibility beside traced primary
// rays, Fetch by rasterization beside Fetch by primitive id. The same bits.

#include "backend_cpu/cpu_backend.h"
#include "backend_cpu/image_footprint.h"
#include "backend_cpu/thread_pool.h"
#include "core/frame/renderer.h"
#include "core/path/camera_rays.h"
#include "core/trace/intersect.h"
#include "tests/frame/shapes.h"
#include "tests/support/simd_targets.h"
#include "tests/support/small_scenes.h"

#include <cstring>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace dirt {
namespace {

bool sameBits(const SurfacePoint& a, const SurfacePoint& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

size_t countDifferent(const std::vector<SurfacePoint>& a, const std::vector<SurfacePoint>& b) {
    EXPECT_EQ(a.size(), b.size());
    size_t different = 0;
    for (size_t i = 0; i < a.size(); ++i) different += !sameBits(a[i], b[i]);
    return different;
}

size_t countFound(const std::vector<SurfacePoint>& points) {
    size_t found = 0;
    for (const SurfacePoint& point : points) found += point.found();
    return found;
}

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

glm::vec3 randomDirection(test::Random& random) {
    glm::vec3 d;
    do d = test::uniformPoint(random, 1.0);
    while (glm::dot(d, d) < 0.01f);
    return d;
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
        if (random.chance(0.7)) scene.camera.target = randomDirection(random);
        if (random.chance(0.7)) scene.camera.up = randomDirection(random);
        const auto raster = firstPoints(scene, settings, Primary::raster, pool);
        const auto traced = firstPoints(scene, settings, Primary::traced, pool);
        ASSERT_EQ(countDifferent(raster, traced), 0u) << "case " << i;
        found += countFound(raster);
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
        camera.target = randomDirection(random);
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
        ASSERT_EQ(countDifferent(firstPoints(scene, settings, Primary::raster, pool),
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
        scene.camera.target = randomDirection(random);
        const auto traced = firstPoints(scene, settings, Primary::traced, pool);
        test::forEachTarget([&] {
            const auto raster = firstPoints(scene, settings, Primary::raster, pool);
            ASSERT_EQ(countDifferent(raster, traced), 0u) << "case " << i;
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
        camera.target = randomDirection(random);
        camera.up = randomDirection(random);
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
        ASSERT_GT(countFound(raster), raster.size() / 4);
        ASSERT_EQ(countDifferent(raster, firstPoints(scene, settings, Primary::traced, pool)), 0u)
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

TEST(ImageFootprint, HoldsEveryPixelThatIsHit) {
    // Slivers that pass pixel centres closely, at the image's rim and through the eye's plane.
    test::Random random(3);
    size_t hits = 0, pixels = 0;
    for (int i = 0; i < test::cases(20'000, 1'000'000); ++i) {
        const int width = random.range(1, 9), height = random.range(1, 9);
        const ViewMode mode = random.chance(0.5) ? ViewMode::full : ViewMode::single;
        Camera camera;
        camera.verticalFov = (float) random.pick({0.5, 20.0, 90.0, 170.0, 179.5});
        camera.target = randomDirection(random);
        camera.up = randomDirection(random);
        const glm::vec2 offset((float) random.below(4) * 0.25f, (float) random.uniform());
        const CameraRays rays(camera, width, height, mode);
        const auto rayAt = [&](int x, int y) {
            return rays.through((float) x + offset.x, (float) y + offset.y);
        };
        // Corners on or beside pixels' rays, at any depth, or anywhere.
        const auto corner = [&] {
            if (random.chance(0.3)) return test::uniformPoint(random, 1.0);
            if (random.chance(0.2)) { // in the eye's plane, exactly or nearly
                const glm::vec3 p = test::uniformPoint(random, 1.0);
                if (mode == ViewMode::single) return glm::vec3(p.x, p.y, 0.0f);
                const glm::vec3 forward = glm::normalize(camera.target);
                return p - forward * glm::dot(p, forward);
            }
            const Ray ray = rayAt(random.range(-1, width), random.range(-1, height));
            const float depth = (float) std::pow(10.0, random.uniform(-4, 0));
            const float beside = random.chance(0.5) ? 0.0f : 1e-7f;
            return ray.direction * depth + test::uniformPoint(random, beside * depth);
        };
        const Triangle triangle{corner(), corner(), corner()};
        const ImageFootprint footprint(camera, width, height, mode, offset);
        const PixelRange range = footprint(triangle);
        uint32_t one[1 + kKeptPadding];
        const bool kept = keepInImage(footprint.cull(), {&triangle, 1}, one) == 1;
        pixels += (size_t) std::max(0, range.x1 - range.x0 + 1) *
                  (size_t) std::max(0, range.y1 - range.y0 + 1);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                TriangleHit hit;
                if (!intersect(rayAt(x, y), triangle, hit)) continue;
                ++hits;
                ASSERT_TRUE(kept) << "case " << i << ", pixel " << x << ", " << y;
                ASSERT_TRUE(x >= range.x0 && x <= range.x1 && y >= range.y0 && y <= range.y1)
                    << "case " << i << ", pixel " << x << ", " << y;
            }
    }
    EXPECT_GT(hits, pixels / 8) << "the range is of use only if it is not much too large";
}

TEST(ImageFootprint, IsSmallWhereVerticesLieInTheEyesPlane) {
    // A floor of 40 x 40 quads on whole numbers, seen from a whole number.
    for (const ViewMode mode : {ViewMode::full, ViewMode::single}) {
        Mesh mesh;
        for (int x = -20; x < 20; ++x)
            for (int z = -20; z < 20; ++z) test::addQuad(mesh, {x, -1, z}, {1, 0, 0}, {0, 0, 1}, 0);
        const Camera camera;
        const FrameGeometry geometry = makeFrameGeometry(mesh, camera, mode);
        const ImageFootprint footprint(camera, 200, 100, mode, {0.5f, 0.5f});
        size_t pixels = 0;
        for (const Triangle& triangle : geometry.triangles) {
            const PixelRange range = footprint(triangle);
            if (range.x0 <= range.x1 && range.y0 <= range.y1)
                pixels += (size_t) (range.x1 - range.x0 + 1) * (size_t) (range.y1 - range.y0 + 1);
        }
        EXPECT_LT(pixels, 4u * 200u * 100u);
    }
}

TEST(ImageFootprint, KeepsWhatItHoldsOnEveryInstructionSet) {
    // Small triangles all around, also at pixels' centres: of those without a pixel few are kept,
    // of the others none is left out.
    test::Random random(9);
    for (const ViewMode mode : {ViewMode::full, ViewMode::single}) {
        Camera camera;
        camera.target = randomDirection(random);
        const ImageFootprint footprint(camera, 300, 200, mode, {0.25f, 0.75f});
        const CameraRays rays(camera, 300, 200, mode);
        std::vector<Triangle> triangles;
        for (int i = 0; i < 5000; ++i) {
            const double size = std::pow(10.0, random.uniform(-6, 0));
            const glm::vec3 d =
                rays.through((float) random.below(300) + 0.25f, (float) random.below(200) + 0.75f)
                    .direction;
            const glm::vec3 center =
                random.chance(0.5) ? test::uniformPoint(random, 1.0) : d * (float) random.uniform();
            triangles.push_back({center + test::uniformPoint(random, size),
                                 center + test::uniformPoint(random, size),
                                 center + test::uniformPoint(random, size)});
        }
        test::forEachTarget([&] {
            std::vector<uint32_t> kept(triangles.size() + kKeptPadding);
            const size_t count = keepInImage(footprint.cull(), triangles, kept.data());
            size_t next = 0, idle = 0;
            for (uint32_t id = 0; id < triangles.size(); ++id) {
                const PixelRange range = footprint(triangles[id]);
                const bool empty = range.x0 > range.x1 || range.y0 > range.y1;
                const bool isKept = next < count && kept[next] == id;
                ASSERT_TRUE(empty || isKept) << "triangle " << id;
                next += isKept;
                idle += empty && isKept;
            }
            EXPECT_EQ(next, count);
            EXPECT_LT(idle, count / 10);
        });
    }
}

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
        EXPECT_EQ(countDifferent(raster, paths.next), 0u) << "event " << event;
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
        scene.camera.target = randomDirection(random);
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
        EXPECT_EQ(countDifferent(after.next, expected), 0u);
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

TEST(RasterFetch, FindsTrianglesThatHoldTheEye) {
    // A triangle through the eye is in the tiles around its own plane only; rays through the eye
    // hit it in none of them.
    const Triangle triangle{{-1, -0.3f, -1}, {1, -0.3f, -1}, {0, 0.6f, 2}};
    Scene scene = test::sceneOf({triangle});
    const glm::dvec3 n =
        glm::cross(glm::dvec3(triangle.b - triangle.a), glm::dvec3(triangle.c - triangle.a));
    ASSERT_EQ(glm::dot(n, glm::dvec3(triangle.a)), 0.0) << "the origin is in the triangle's plane";
    RenderSettings settings;
    settings.grid.width = settings.grid.height = 33;
    settings.grid.tile = 4;
    settings.bounces = 1;
    SerialExecutor serial;
    size_t records = 0;
    expectSameFetches(scene, settings, serial, records);
    EXPECT_EQ(records, 33u * 33u) << "every primary ray starts on the triangle";
}

} // namespace
} // namespace dirt
