#include "core/trace/intersect.h"
#include "shaders/shared/margins.h"
#include "tests/support/exact_ray.h"
#include "tests/support/nasty_rays.h"
#include "tests/support/print.h"

#include <gtest/gtest.h>

#include <cfloat>
#include <limits>
#include <map>
#include <string>

// T4: the decision by exact signs, and the errors of t and the barycentric weights.

namespace dirt::test {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// |f - exact| <= bound, exactly.
bool isWithin(float f, const Fraction& exact, const Fraction& bound) {
    const int unit = std::min({f == 0 ? 0 : lowestExponent(f), exact.exponent, bound.exponent});
    const Integer difference =
        abs(toInteger(f, unit) * exact.denominator - (exact.numerator << (exact.exponent - unit)));
    return difference * bound.denominator <=
           (bound.numerator << (bound.exponent - unit)) * exact.denominator;
}

std::string violation(const RayCase& c) {
    TriangleHit hit;
    const bool found = intersect(c.ray, c.triangle, hit);
    const ExactHit exact = intersectExactly(c.ray, c.triangle);
    if (found != exact.hit) return found ? "false hit" : "missed";
    if (!found) return "";
    const double t = exact.t.value();
    if (t < FLT_MIN * (1 + 0x1p-22)) {
        if (!(hit.t == 0.0f || (t > FLT_MIN * (1 - 0x1p-22) && hit.t == FLT_MIN)))
            return "t below FLT_MIN is not zero";
    } else if (t <= FLT_MAX) {
        Fraction bound = exact.t;
        bound.exponent -= 23;
        if (!isWithin(hit.t, exact.t, bound)) return "t is beyond its bound: " + hex(hit.t);
    }
    const Fraction bound{1, 1, -23};
    if (!isWithin(hit.u, exact.u, bound)) return "u is beyond its bound: " + hex(hit.u);
    if (!isWithin(hit.v, exact.v, bound)) return "v is beyond its bound: " + hex(hit.v);
    return "";
}

TEST(Intersect, DecidesAsExactArithmetic) {
    EXPECT_GT(kRelativeErrorT, 0x1p-23f); // of two hits; one alone is held to 2^-23 here
    Random random(4);
    NastyRays rays(random);
    std::map<std::string, int> failures;
    const int total = cases(100'000, 2'000'000);
    int hits = 0;
    for (int i = 0; i < total; ++i) {
        const RayCase c = rays.next();
        const std::string wrong = violation(c);
        TriangleHit hit;
        hits += intersect(c.ray, c.triangle, hit);
        if (wrong.empty()) continue;
        if (++failures[wrong.substr(0, 12) + " (" + c.kind + ")"] <= 2)
            ADD_FAILURE() << wrong << "\n"
                          << hex(c.ray) << "\n"
                          << hex(c.triangle) << " (" << c.kind << ")";
    }
    for (const auto& [what, count] : failures) ADD_FAILURE() << count << " times " << what;
    EXPECT_GT(hits, total / 10);
}

TEST(Intersect, FromOneOriginIsTheSame) {
    Random random(11);
    NastyRays rays(random);
    int hits = 0;
    for (int i = 0; i < cases(5'000, 200'000); ++i) {
        const RayCase c = rays.next();
        const TriangleFrom triangle(c.ray.origin, c.triangle);
        // The same ray again after another has been asked for.
        for (const glm::vec3 d : {c.ray.direction, rays.direction(), c.ray.direction}) {
            TriangleHit expected, hit;
            const bool found = intersect({c.ray.origin, d, kNoPrimitive}, c.triangle, expected);
            ASSERT_EQ(triangle.intersect(d, hit), found) << hex(c.ray) << hex(c.triangle);
            if (!found) continue;
            ++hits;
            ASSERT_TRUE(hit.t == expected.t && hit.u == expected.u && hit.v == expected.v)
                << hex(c.ray) << hex(c.triangle);
        }
    }
    EXPECT_GT(hits, 1'000);
}

TEST(Intersect, DecidesTheSameForEveryOrderOfVertices) {
    Random random(5);
    NastyRays rays(random);
    for (int i = 0; i < cases(20'000, 200'000); ++i) {
        const RayCase c = rays.next();
        const Triangle& t = c.triangle;
        const Triangle orders[] = {t, {t.b, t.c, t.a}, {t.c, t.a, t.b}, {t.a, t.c, t.b}};
        TriangleHit first, other;
        const bool found = intersect(c.ray, t, first);
        for (const Triangle& order : orders)
            ASSERT_EQ(intersect(c.ray, order, other), found) << hex(c.ray) << "\n" << hex(order);
    }
}

TEST(Intersect, HitsAtZeroAndNotBefore) {
    const Triangle t{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}};
    TriangleHit hit;
    ASSERT_TRUE(intersect({{0.25f, 0.25f, 1.0f}, {0, 0, 1}}, t, hit));
    EXPECT_EQ(hit.t, 0.0f);
    EXPECT_TRUE(intersect({{0.25f, 0.25f, std::nextafter(1.0f, 0.0f)}, {0, 0, 1}}, t, hit));
    EXPECT_FALSE(intersect({{0.25f, 0.25f, std::nextafter(1.0f, 2.0f)}, {0, 0, 1}}, t, hit));
}

TEST(Intersect, HitsClosedBorders) {
    const Triangle t{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}};
    TriangleHit hit;
    for (glm::vec2 on : {glm::vec2(0, 0), {1, 0}, {0, 1}, {0.5f, 0}, {0, 0.5f}, {0.5f, 0.5f}})
        EXPECT_TRUE(intersect({{on.x, on.y, 0}, {0, 0, 1}}, t, hit)) << on.x << ' ' << on.y;
    const float tiny = FLT_MIN;
    EXPECT_FALSE(intersect({{-tiny, 0, 0}, {0, 0, 1}}, t, hit));
    EXPECT_FALSE(intersect({{0.5f, std::nextafter(0.5f, 1.0f), 0}, {0, 0, 1}}, t, hit));
}

TEST(Intersect, NothingInThePlaneOrWithoutArea) {
    TriangleHit hit;
    const Triangle t{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}};
    EXPECT_FALSE(intersect({{-1, 0.25f, 1}, {1, 0, 0}}, t, hit));
    EXPECT_FALSE(intersect({{0, 0, 1}, {1, 0, 0}}, t, hit));
    const Triangle segment{{0, 0, 1}, {1, 0, 1}, {0.5f, 0, 1}},
        point{{0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
    EXPECT_FALSE(intersect({{0.5f, 0, 0}, {0, 0, 1}}, segment, hit));
    EXPECT_FALSE(intersect({{0, 0, 0}, {0, 0, 1}}, point, hit));
}

TEST(Intersect, WeightsAddUpWithinTheTriangle) {
    Random random(6);
    NastyRays rays(random);
    for (int i = 0; i < 20'000; ++i) {
        const RayCase c = rays.next();
        TriangleHit hit;
        if (!intersect(c.ray, c.triangle, hit)) continue;
        ASSERT_GE(hit.u, 0.0f) << hex(c.ray) << "\n" << hex(c.triangle);
        ASSERT_GE(hit.v, 0.0f) << hex(c.ray) << "\n" << hex(c.triangle);
        ASSERT_LE(hit.u + hit.v, 1.0f + 0x1p-21f) << hex(c.ray) << "\n" << hex(c.triangle);
        ASSERT_GE(hit.t, 0.0f) << hex(c.ray) << "\n" << hex(c.triangle);
    }
}

TEST(Intersect, SameVerticesInAnyOrder) {
    const glm::vec3 a{0, 0, 1}, b{1, 0, 1}, c{0, 1, 1}, d{0, 1, std::nextafter(1.0f, 2.0f)};
    for (const Triangle& t :
         {Triangle{a, b, c}, {b, c, a}, {c, a, b}, {a, c, b}, {c, b, a}, {b, a, c}})
        EXPECT_TRUE(sameVertices(t, {a, b, c}));
    EXPECT_FALSE(sameVertices({a, b, c}, {a, b, d}));
    // Sets that are equal only if repetitions are not counted.
    EXPECT_FALSE(sameVertices({a, a, b}, {a, b, b}));
    EXPECT_FALSE(sameVertices({a, b, b}, {a, a, b}));
    EXPECT_TRUE(sameVertices({a, a, b}, {b, a, a}));
    EXPECT_TRUE(sameVertices({a, a, a}, {a, a, a}));
    EXPECT_TRUE(sameVertices({{0, 0, -0.0f}, b, c}, {{0, 0, 0}, b, c}));
}

TEST(Intersect, TraceableRaysAreFiniteAndGoSomewhere) {
    EXPECT_TRUE(isTraceable({{0, 0, 0}, {0, 0, 1}}));
    EXPECT_TRUE(isTraceable({{FLT_MAX, FLT_MAX, FLT_MAX}, {FLT_MAX, FLT_MAX, -FLT_MAX}}));
    EXPECT_TRUE(isTraceable({{0, 0, 0}, {0, FLT_MIN, 0}}));
    EXPECT_FALSE(isTraceable({{0, 0, 0}, {0, 0, 0}}));
    EXPECT_FALSE(isTraceable({{0, 0, 0}, {0, -0.0f, 0}}));
    for (float bad : {kNaN, -kNaN, kInfinity, -kInfinity})
        for (int i = 0; i < 3; ++i) {
            Ray ray{{0, 0, 0}, {1, 1, 1}};
            ray.origin[i] = bad;
            EXPECT_FALSE(isTraceable(ray));
            ray = {{0, 0, 0}, {1, 1, 1}};
            ray.direction[i] = bad;
            EXPECT_FALSE(isTraceable(ray));
        }
}

} // namespace
} // namespace dirt::test
