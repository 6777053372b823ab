// The parallel SIMD builder against the readable one in core: the same bits for any number of
// threads and every instruction set this machine has.

#include "backend_cpu/cpu_backend.h"
#include "backend_cpu/thread_pool.h"
#include "core/io/load.h"
#include "tests/io/test_scenes.h"
#include "tests/support/corner_triangles.h"
#include "tests/support/print.h"
#include "tests/support/simd_targets.h"
#include "tests/support/small_scenes.h"

#include <gtest/gtest.h>

#include <cstring>

namespace dirt::test {
namespace {

template <class T>
bool sameBytes(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

void expectSameGrid(const Grid& a, const Grid& b, const std::string& what = {}) {
    ASSERT_EQ(a.pyramids.size(), b.pyramids.size()) << what;
    for (size_t v = 0; v < a.pyramids.size(); ++v) {
        ASSERT_EQ(a.pyramids[v].levels.size(), b.pyramids[v].levels.size()) << what;
        for (size_t l = 0; l < a.pyramids[v].levels.size(); ++l)
            ASSERT_TRUE(sameBytes(a.pyramids[v].levels[l].bounds, b.pyramids[v].levels[l].bounds))
                << "view " << v << ", level " << l << ", " << what;
    }
    ASSERT_TRUE(sameBytes(a.heads, b.heads)) << what;
    ASSERT_TRUE(sameBytes(a.ids, b.ids)) << what;
    ASSERT_EQ(a.atEye, b.atEye) << what;
}

std::string settingsText(const GridSettings& s) {
    return std::string(s.mode == ViewMode::full ? "full" : "single") + ", view " +
           std::to_string(s.viewSize) + ", image " + std::to_string(s.width) + "x" +
           std::to_string(s.height) + ", tile " + std::to_string(s.tile) + ", bins " +
           std::to_string(s.bins);
}

GridSettings randomSettings(Random& random) {
    GridSettings settings;
    settings.mode = random.chance(0.7) ? ViewMode::full : ViewMode::single;
    settings.tile = random.pick({1, 1, 2, 3, 4, 7, 16, 33, 64});
    const int tiles = random.pick({1, 2, 3, 8, 17, 32, 64});
    settings.viewSize = std::max(1, tiles * settings.tile - random.below(settings.tile));
    settings.width = settings.viewSize + random.below(40);
    settings.height = settings.viewSize;
    settings.bins = random.pick({1, 2, 16, 44, 256});
    return settings;
}

/// Triangles of one tile and of many, degenerate, edge-on, through and around the eye, tiny and
/// huge, on borders and just beside them; some with coordinates near the ends of float's range.
FrameGeometry nastyGeometry(Random& random, const ViewSet& set, int triangles) {
    FrameGeometry geometry;
    while ((int) geometry.triangles.size() < triangles) {
        for (const Triangle& t : smallScene(random, set)) geometry.triangles.push_back(t);
        for (int i = 0; i < 30; ++i) {
            const glm::vec3 centre = uniformPoint(random, 1.0);
            const double size = std::pow(10.0, random.uniform(-5, -2));
            geometry.triangles.push_back({centre + uniformPoint(random, size),
                                          centre + uniformPoint(random, size),
                                          centre + uniformPoint(random, size)});
        }
    }
    for (Triangle& t : geometry.triangles) {
        if (!random.chance(0.03)) continue;
        const float scale = std::ldexp(1.0f, random.range(-100, 30));
        t = {t.a * scale, t.b * scale, t.c * scale};
    }
    return geometry;
}

/// With every target and several numbers of threads, over what the last build left behind.
void expectEqualToDefinition(const FrameGeometry& geometry, const Camera& camera,
                             const GridSettings& settings, const std::string& what) {
    struct Builder {
        ThreadPool pool;
        GridBuilder builder{pool};
        explicit Builder(unsigned threads) : pool(threads) {}
    };
    static Builder builders[] = {Builder(1), Builder(2), Builder(7)};
    const Grid oracle = buildGrid(geometry, camera, settings);
    forEachTarget([&] {
        for (auto& [pool, builder] : builders) {
            Grid grid = makeEmptyGrid(camera, settings);
            builder.fillDepth(geometry, grid);
            builder.fillDepthMipmap(grid);
            builder.fillPrimitives(grid);
            expectSameGrid(oracle, grid, what + ", " + std::to_string(pool.threads()) + " threads");
        }
    });
}

TEST(GridBuilder, EqualsTheDefinitionOnNastyTriangles) {
    Random random(71);
    for (int round = 0; round < cases(25, 3000); ++round) {
        Camera camera;
        camera.verticalFov = random.pick({1e-5f, 0.1f, 1.0f, 53.0f, 90.0f, 150.0f, 179.0f});
        const ViewSet set(randomSettings(random), camera);
        const FrameGeometry geometry = nastyGeometry(random, set, 300);
        expectEqualToDefinition(geometry, set.camera, set.settings, settingsText(set.settings));
        if (HasFatalFailure()) return;
    }
}

TEST(GridBuilder, EqualsTheDefinitionOnEdgesThroughCorners) {
    Random random(73);
    for (int round = 0; round < cases(6, 100); ++round) {
        const ViewSet set = fullViews(random.range(4, 40), random.pick({1, 3}));
        FrameGeometry geometry;
        for (int i = 0; i < 500; ++i)
            geometry.triangles.push_back(
                throughCorner(random, set.views[(size_t) random.below(6)]).triangle);
        expectEqualToDefinition(geometry, set.camera, set.settings, settingsText(set.settings));
        if (HasFatalFailure()) return;
    }
}

TEST(GridBuilder, EqualsTheDefinitionOverManyPieces) {
    Random random(72);
    for (const int tile : {4, 16, 64}) {
        const ViewSet set = fullViews(130, tile);
        const FrameGeometry geometry = nastyGeometry(random, set, 2500);
        expectEqualToDefinition(geometry, set.camera, set.settings, settingsText(set.settings));
    }
}

/// The most tiles that a view may have: what the bounds of positions are derived for.
TEST(GridBuilder, EqualsTheDefinitionAtTheFinestTiles) {
    Random random(73);
    for (const ViewSet& set : {singleView(8192, 3, 1, 90.0f), singleView(5, 8192, 1, 1.0f)}) {
        FrameGeometry geometry;
        for (int i = 0; i < cases(10000, 2000000); ++i) {
            // Near borders, at the size of a tile.
            const double w = random.uniform(0.1, 1.0), size = w * random.uniform(0.0, 3.0);
            const View& view = set.views[0];
            const double tileX = (view.s[1] - view.s[0]), tileY = (view.t[1] - view.t[0]);
            const double x = view.s[random.below(view.columns + 1)] * w;
            const double y = view.t[random.below(view.rows + 1)] * w;
            const auto corner = [&] {
                return glm::vec3(x + random.uniform(-1, 1) * tileX * size,
                                 y + random.uniform(-1, 1) * tileY * size, w);
            };
            geometry.triangles.push_back({corner(), corner(), corner()});
        }
        expectEqualToDefinition(geometry, set.camera, set.settings, settingsText(set.settings));
    }
}

TEST(GridBuilder, EqualsTheDefinitionOnARealScene) {
    const std::filesystem::path file = scenesFolder() / "conference/conference.obj";
    if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not there";
    const Scene scene = loadScene(file).scene;
    Camera camera;
    camera.eye = {900, 400, 500};
    camera.target = {0, 150, -300};
    for (const ViewMode mode : {ViewMode::full, ViewMode::single}) {
        GridSettings settings;
        settings.mode = mode;
        const FrameGeometry geometry = makeFrameGeometry(scene.mesh, camera, mode);
        expectEqualToDefinition(geometry, camera, settings, settingsText(settings));
    }
}

FrameGeometry soup(int count, uint64_t seed) {
    Random random(seed);
    FrameGeometry geometry;
    addSoup(random, geometry.triangles, count);
    return geometry;
}

TEST(GridBuilder, BuildsAgainWithoutTraces) {
    ThreadPool pool(2);
    CpuBackend backend(pool);
    const Camera camera;
    const GridSettings settings;
    backend.build(soup(500, 1), camera, settings);
    const FrameGeometry second = soup(200, 2);
    backend.build(second, camera, settings);
    expectSameGrid(buildGrid(second, camera, settings), backend.grid());
}

TEST(GridBuilder, TellsItsMemoryWhenTheGeometryIsGone) {
    ThreadPool pool(1);
    CpuBackend backend(pool);
    backend.build(soup(100, 3), Camera{}, GridSettings{});
    uint64_t bytes = 0;
    for (const BufferSize& buffer : backend.memory())
        if (buffer.name == "triangle buffer") bytes = buffer.bytes;
    EXPECT_EQ(bytes, 100 * sizeof(Triangle));
}

TEST(GridBuilder, NoGeometry) {
    ThreadPool pool(2);
    CpuBackend backend(pool);
    const FrameGeometry empty;
    backend.build(empty, Camera{}, GridSettings{});
    EXPECT_EQ(backend.listEntries(), 0u);
    const Ray ray{{0, 0, 0}, {1, 2, 3}, kNoPrimitive};
    Hit hit;
    backend.intersect({&ray, 1}, {&hit, 1});
    EXPECT_FALSE(hit.found());
}

} // namespace
} // namespace dirt::test
