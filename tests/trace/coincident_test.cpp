// Triangles in one place (T3, T5): which of them is hit, and that a ray leaves them all.

#include "core/trace/intersect.h"
#include "core/trace/traverse.h"
#include "shaders/shared/margins.h"
#include "tests/support/grid_rays.h"
#include "tests/support/print.h"
#include "tests/support/random.h"
#include "tests/support/same_hit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include <glm/geometric.hpp>

namespace dirt::test {
namespace {

FrameGeometry twins() {
    const Triangle t{{-1, -1, 0.5f}, {1, -1, 0.5f}, {0, 1, 0.5f}};
    FrameGeometry geometry;
    geometry.triangles = {{{-1, -1, 0.75f}, {1, -1, 0.75f}, {0, 1, 0.75f}},
                          t,
                          {t.b, t.a, t.c},
                          t,
                          {{-1, -1, 0.5f}, {1, -1, 0.5f}, {0, 1.5f, 0.5f}}};
    return geometry;
}

/// One triangle with its corners in other orders: exactly as near, but each t has roundings of its
/// own, so that the lowest id goes first among those alone whose t are the same float.
TEST(Coincident, TakesTheLeastOfWhatCoincidentTrianglesComputed) {
    Random random(77);
    const ViewSet set = fullViews(16, 4);
    int hits = 0, unequal = 0, higher = 0;
    for (int round = 0; round < 60; ++round) {
        std::vector<Triangle> triangles;
        const auto point = [&] {
            return glm::vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
        };
        for (int i = 0; i < 8; ++i) {
            const Triangle t{point(), point(), point()};
            triangles.insert(triangles.end(), {t, {t.b, t.a, t.c}, {t.c, t.a, t.b}});
        }
        FrameGeometry geometry;
        geometry.triangles = triangles;
        const Grid grid = buildGrid(geometry, set.camera, set.settings);
        for (int i = 0; i < 200; ++i) {
            // Almost within one's plane, where double leaves t the fewest digits.
            const Triangle& one = triangles[(size_t) random.below((int) triangles.size())];
            const glm::vec3 ab = one.b - one.a, ac = one.c - one.a;
            const glm::vec3 normal = glm::normalize(glm::cross(ab, ac));
            const glm::vec3 along = glm::normalize(ab + 0.25f * ac);
            const glm::vec3 direction = along + (float) random.uniform(1e-6, 1e-5) * normal;
            const glm::vec3 middle = (one.a + one.b + one.c) / 3.0f;
            const Ray ray{middle - (float) random.uniform(0.25, 2) * direction, direction};
            const Hit hit = closestHit(grid, geometry, ray);
            ASSERT_TRUE(sameHit(hit, closestHitBruteForce(geometry, ray))) << hex(ray);
            if (!hit.found()) continue;
            ++hits;
            const uint32_t first = hit.primitive / 3 * 3;
            float t[3];
            for (uint32_t k = 0; k < 3; ++k) {
                TriangleHit twin;
                ASSERT_TRUE(intersect(ray, triangles[first + k], twin)) << "hit or miss is exact";
                t[k] = twin.t;
                EXPECT_LE(std::abs(twin.t - hit.t), kRelativeErrorT * hit.t) << "err(t)";
            }
            const auto least = (uint32_t) (std::min_element(t, t + 3) - t); // the first of equals
            EXPECT_EQ(hit.primitive, first + least);
            unequal += t[0] != t[1] || t[1] != t[2];
            higher += hit.primitive != first;
        }
    }
    EXPECT_GT(hits, 1000);
    EXPECT_GT(higher, 0) << "else this says nothing";
    EXPECT_LT(unequal, hits / 4);
    RecordProperty("unequal", std::to_string(unequal) + " of " + std::to_string(hits));
}

TEST(Coincident, TakesTheLowestIdOfCoincidentTriangles) {
    const FrameGeometry geometry = twins();
    const ViewSet set = fullViews(16, 4);
    const Grid grid = buildGrid(geometry, set.camera, set.settings);
    for (const Ray& ray :
         {Ray{{0, 0, 0}, {0, 0, 1}}, {{0.1f, 0, 0.25f}, {0, 0, 1}}, {{0, 0, 0.625f}, {0, 0, -1}}}) {
        const Hit hit = closestHit(grid, geometry, ray);
        EXPECT_EQ(hit.primitive, 1u);
        EXPECT_TRUE(sameHit(hit, closestHitBruteForce(geometry, ray)));
    }
}

TEST(Coincident, SkipsATriangleAndItsTwins) {
    const FrameGeometry geometry = twins();
    const ViewSet set = fullViews(16, 4);
    const Grid grid = buildGrid(geometry, set.camera, set.settings);
    for (uint32_t skip : {1u, 2u, 3u}) {
        const Ray ray{{0, 0, 0}, {0, 0, 1}, skip};
        EXPECT_EQ(closestHit(grid, geometry, ray).primitive, 4u);
        EXPECT_EQ(closestHitBruteForce(geometry, ray).primitive, 4u);
        EXPECT_TRUE(anyHit(grid, geometry, ray, 1.0f));
    }
    const Ray ray{{0, 0, 0}, {0, 0, 1}, 4u};
    EXPECT_EQ(closestHit(grid, geometry, ray).primitive, 1u);
    EXPECT_FALSE(anyHit(grid, geometry, {{0, 0, 0.625f}, {0, 0, 1}, 0u}, 1.0f));
}

} // namespace
} // namespace dirt::test
