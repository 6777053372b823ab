// The float test of --precision fast: right where nothing is close, and not where rays are aimed at
// edges, which is why the other one is the default.

#include "core/trace/plain_intersect.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace dirt::test {
namespace {

class RandomPoints {
public:
    glm::vec3 point() { return {number(), number(), number()}; }
    float number() { return uniform_(generator_); }

private:
    std::mt19937 generator_{7};
    std::uniform_real_distribution<float> uniform_{-1.0f, 1.0f};
};

TEST(PlainIntersect, FindsTheExactHitOfRaysThroughTheInside) {
    RandomPoints random;
    int hits = 0, misses = 0;
    for (int i = 0; i < 100'000; ++i) {
        const Triangle t{random.point(), random.point(), random.point()};
        const Ray ray{random.point(), random.point(), kNoPrimitive};
        TriangleHit exact, plain;
        const bool hit = intersect(ray, t, exact);
        // Within 1/1000 of an edge or of the origin either answer will do here.
        const float nearest = std::min({exact.u, exact.v, 1.0f - exact.u - exact.v, exact.t});
        if (hit && nearest < 1e-3f) continue;
        if (!hit) {
            misses += plainIntersect(ray, t, plain) ? 0 : 1;
            continue;
        }
        ASSERT_TRUE(plainIntersect(ray, t, plain)) << i;
        ++hits;
        // A few ulp of the coordinates over the cosine; these rays are no more grazing than that.
        EXPECT_NEAR(plain.t, exact.t, 1e-3f * exact.t);
        EXPECT_NEAR(plain.u, exact.u, 1e-3f);
        EXPECT_NEAR(plain.v, exact.v, 1e-3f);
    }
    EXPECT_GT(hits, 3'000);
    EXPECT_GT(misses, 50'000);
}

TEST(PlainIntersect, DisagreesWithTheExactRayAtEdges) {
    RandomPoints random;
    int lost = 0, invented = 0;
    for (int i = 0; i < 100'000; ++i) {
        const Triangle t{random.point(), random.point(), random.point()};
        const float s = 0.5f + 0.5f * random.number();
        const glm::vec3 origin = random.point();
        const Ray ray{origin, t.a * (1.0f - s) + t.b * s - origin, kNoPrimitive};
        TriangleHit exact, plain;
        const bool hit = intersect(ray, t, exact), plainHit = plainIntersect(ray, t, plain);
        lost += hit && !plainHit;
        invented += !hit && plainHit;
    }
    EXPECT_GT(lost, 1'000);
    EXPECT_GT(invented, 1'000);
}

TEST(PlainIntersect, RefusesWhatHasNoAreaAndWhatIsNoNumber) {
    TriangleHit hit;
    const Ray ray{{0, 0, -1}, {0, 0, 1}, kNoPrimitive};
    EXPECT_TRUE(plainIntersect(ray, {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}}, hit));
    EXPECT_FLOAT_EQ(hit.t, 1.0f);
    EXPECT_FALSE(plainIntersect(ray, {{-1, 0, 0}, {0, 0, 0}, {1, 0, 0}}, hit)); // through the ray
    EXPECT_FALSE(plainIntersect(ray, {{-1, -1, -2}, {1, -1, -2}, {0, 1, -2}}, hit)); // behind
    EXPECT_FALSE(plainIntersect(ray, {{NAN, -1, 0}, {1, -1, 0}, {0, 1, 0}}, hit));
}

} // namespace
} // namespace dirt::test
