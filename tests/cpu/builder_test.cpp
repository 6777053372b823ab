// The parallel builder against the readable one in core: the same bits for any number of threads.

#include "backend_cpu/cpu_backend.h"
#include "backend_cpu/thread_pool.h"

#include <gtest/gtest.h>

#include <cstring>
#include <random>

namespace dirt {
namespace {

FrameGeometry randomGeometry(int count, float size, uint32_t seed) {
    std::mt19937 random(seed);
    const auto unit = [&] { return (float) (random() >> 8) * 0x1p-23f - 1.0f; };
    FrameGeometry geometry;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 centre(unit(), unit(), unit());
        const auto corner = [&] { return centre + size * glm::vec3(unit(), unit(), unit()); };
        geometry.triangles.push_back({corner(), corner(), corner()});
    }
    return geometry;
}

template <class T>
bool sameBytes(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

void expectSameGrid(const Grid& a, const Grid& b) {
    ASSERT_EQ(a.pyramids.size(), b.pyramids.size());
    for (size_t v = 0; v < a.pyramids.size(); ++v) {
        ASSERT_EQ(a.pyramids[v].levels.size(), b.pyramids[v].levels.size());
        for (size_t l = 0; l < a.pyramids[v].levels.size(); ++l)
            EXPECT_TRUE(sameBytes(a.pyramids[v].levels[l].bounds, b.pyramids[v].levels[l].bounds));
    }
    EXPECT_TRUE(sameBytes(a.heads, b.heads));
    EXPECT_TRUE(sameBytes(a.ids, b.ids));
    EXPECT_EQ(a.atEye, b.atEye);
}

TEST(GridBuilder, EqualsTheDefinition) {
    for (int tile : {1, 4, 16, 64})
        for (int bins : {1, 16, 44})
            for (ViewMode mode : {ViewMode::full, ViewMode::single}) {
                const FrameGeometry geometry = randomGeometry(3000, 0.2f, (uint32_t) (tile + bins));
                GridSettings settings{mode, 133, 71, 67, tile, bins, -1, Traversal::hierarchical};
                const Camera camera;
                const Grid oracle = buildGrid(geometry, camera, settings);
                for (unsigned threads : {1u, 2u, 7u}) {
                    ThreadPool pool(threads);
                    CpuBackend backend(pool);
                    backend.build(geometry, camera, settings);
                    expectSameGrid(oracle, backend.grid());
                }
            }
}

TEST(GridBuilder, BuildsAgainWithoutTraces) {
    ThreadPool pool(2);
    CpuBackend backend(pool);
    const Camera camera;
    const GridSettings settings;
    backend.build(randomGeometry(500, 0.5f, 1), camera, settings);
    const FrameGeometry second = randomGeometry(200, 0.1f, 2);
    backend.build(second, camera, settings);
    expectSameGrid(buildGrid(second, camera, settings), backend.grid());
}

TEST(GridBuilder, TellsItsMemoryWhenTheGeometryIsGone) {
    ThreadPool pool(1);
    CpuBackend backend(pool);
    backend.build(randomGeometry(100, 0.5f, 3), Camera{}, GridSettings{});
    uint64_t bytes = 0;
    for (const auto& [buffer, size] : backend.memory())
        if (buffer == "triangle buffer") bytes = size;
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
} // namespace dirt
