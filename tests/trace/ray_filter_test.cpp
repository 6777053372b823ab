// The float filter against the exact decision: never wrong, and rarely undecided.

#include "core/trace/ray_filter.h"

#include "core/trace/intersect.h"
#include "tests/support/nasty_rays.h"
#include "tests/support/print.h"

#include <gtest/gtest.h>

namespace dirt::test {
namespace {

float extentOf(const Triangle& t) {
    float extent = 0.0f;
    for (const glm::vec3& v : {t.a, t.b, t.c})
        for (int i = 0; i < 3; ++i) extent = std::max(extent, std::abs(v[i]));
    return extent;
}

TEST(RayFilter, NeverRefusesAHit) {
    Random random(41);
    NastyRays rays(random);
    int hits = 0;
    for (int i = 0; i < 300'000; ++i) {
        const RayCase c = rays.next();
        if (!isTraceable(c.ray)) continue;
        TriangleHit hit;
        if (!intersect(c.ray, c.triangle, hit)) continue;
        ++hits;
        ASSERT_FALSE(RayFilter(c.ray, extentOf(c.triangle)).certainlyMisses(c.triangle))
            << hex(c.ray) << "\n"
            << hex(c.triangle);
    }
    EXPECT_GT(hits, 30'000);
}

TEST(RayFilter, DecidesNothingAtOverflowingDistances) {
    const Triangle t{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}};
    const Ray ray{{FLT_MAX, -FLT_MAX, FLT_MAX}, {-FLT_MAX, FLT_MAX, -1.0f}};
    EXPECT_FALSE(RayFilter(ray).certainlyMisses(t));
}

TEST(RayFilter, DecidesNearlyAllOrdinaryMisses) {
    Random random(42);
    NastyRays rays(random);
    int misses = 0, undecided = 0;
    for (int i = 0; i < 100'000; ++i) {
        const auto point = [&] {
            return glm::vec3((float) random.uniform(-1, 1), (float) random.uniform(-1, 1),
                             (float) random.uniform(-1, 1));
        };
        const glm::vec3 centre = point();
        const Triangle t{centre + 0.01f * point(), centre + 0.01f * point(),
                         centre + 0.01f * point()};
        // Close by, where bounding boxes no longer help.
        Ray ray{point(), {}, kNoPrimitive};
        ray.direction = centre + 0.01f * point() - ray.origin;
        TriangleHit hit;
        if (intersect(ray, t, hit)) continue;
        ++misses;
        undecided += !RayFilter(ray).certainlyMisses(t);
    }
    EXPECT_GT(misses, 50'000);
    EXPECT_LT(undecided, misses / 1000);
}

} // namespace
} // namespace dirt::test
