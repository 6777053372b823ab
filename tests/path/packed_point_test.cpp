// Surface points in 32 bytes: what they keep exactly, and how far the rest is off at most.

#include "core/frame/point_buffer.h"
#include "core/path/fetch_surface.h"
#include "core/trace/determinant.h"
#include "core/trace/offset.h"
#include "shaders/shared/reflection.h"
#include "tests/support/nasty_triangles.h"

#include <cmath>
#include <cstring>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace dirt::test {
namespace {

template <typename T>
bool sameBits(const T& a, const T& b) {
    return std::memcmp(&a, &b, sizeof(T)) == 0;
}

const Triangle kTriangle{{0.25f, 0.5f, -1.0f}, {1.25f, 0.25f, -1.5f}, {0.5f, 1.5f, -0.75f}};

SurfacePoint pointOn(const Triangle& t) {
    SurfacePoint point;
    point.primitive = 0;
    point.u = 0.25f;
    point.v = 0.5f;
    point.position = interpolate(t.a, t.b, t.c, point.u, point.v);
    point.geometricNormal = point.shadingNormal = triangleNormal(t.a, t.b, t.c);
    return point;
}

SurfacePoint roundTrip(const SurfacePoint& point, const Triangle& t) {
    return unpackPoint(packPoint(point, t.a, t.b, t.c), t.a, t.b, t.c);
}

glm::vec3 roundTrip(glm::vec3 colour, int bits) {
    SurfacePoint point = pointOn(kTriangle);
    (bits == kDiffuseBits ? point.diffuse : point.emission) = colour;
    const SurfacePoint back = roundTrip(point, kTriangle);
    return bits == kDiffuseBits ? back.diffuse : back.emission;
}

glm::vec3 randomDirection(Random& random) {
    for (;;) {
        const glm::vec3 v((float) random.uniform(-1, 1), (float) random.uniform(-1, 1),
                          (float) random.uniform(-1, 1));
        const float square = glm::dot(v, v);
        if (square > 0.01f && square < 1.0f) return unitVector(v);
    }
}

TEST(PackedPoint, RoundsColoursByAPartOfTheirLargestComponent) {
    Random random(1);
    for (const int bits : {kDiffuseBits, kEmissionBits}) {
        double worst = 0.0;
        for (int i = 0; i < 20'000; ++i) {
            glm::vec3 colour;
            const double common = random.uniform(-8, 8);
            for (int c = 0; c < 3; ++c)
                colour[c] =
                    random.chance(0.1) ? 0.0f : (float) std::abs(random.wide(common - 1, common));
            const glm::vec3 back = roundTrip(colour, bits);
            const double largest = std::max({colour.x, colour.y, colour.z});
            // Half a step where the largest mantissa is at least 2^(bits-1); where rounding it up
            // doubles the step, 2^-bits more of that. The sum with 1/2 is rounded by 2^-24.
            const double bound = std::ldexp(largest, -bits) * (1.0 + std::ldexp(1.0, 1 - bits));
            for (int c = 0; c < 3; ++c) {
                const double error = std::abs((double) back[c] - (double) colour[c]);
                ASSERT_LE(error, bound) << colour.x << " " << colour.y << " " << colour.z;
                if (largest > 0.0) worst = std::max(worst, error / bound);
            }
            ASSERT_TRUE(sameBits(roundTrip(back, bits), back));
            // What reflects no more than it receives still does not.
            const glm::vec3 below = colour / (float) std::max(largest, 1e-30);
            const glm::vec3 albedo = roundTrip(below, bits);
            ASSERT_LE(std::max({albedo.x, albedo.y, albedo.z}), 1.0f);
        }
        EXPECT_GT(worst, 0.9); // the bound is no guess
    }
}

TEST(PackedPoint, KeepsColoursAtTheEndsOfTheirRange) {
    for (const int bits : {kDiffuseBits, kEmissionBits}) {
        for (const float value : {0.0f, 1.0f, 0.5f, 0x1p-97f, 0x1p127f, 96.0f})
            EXPECT_EQ(roundTrip(glm::vec3(value), bits), glm::vec3(value)) << value;
        EXPECT_EQ(roundTrip(glm::vec3(0x1p-98f), bits), glm::vec3(0.0f));
        EXPECT_EQ(roundTrip(glm::vec3(3e38f, 1.0f, 0.0f), bits), glm::vec3(0x1p127f, 0.0f, 0.0f));
        EXPECT_EQ(roundTrip(glm::vec3(HUGE_VALF), bits), glm::vec3(0x1p127f));
    }
}

TEST(PackedPoint, RoundsNormalsByASmallAngle) {
    Random random(2);
    double worst = 0.0;
    const auto check = [&](glm::vec3 normal) {
        const glm::vec3 back = unpackNormal(packNormal(normal));
        // By the derivation beside packNormal; its few float operations add some 2^-22.
        const double angle = glm::length(glm::dvec3(back) - glm::dvec3(normal));
        worst = std::max(worst, angle);
        ASSERT_LT(angle, std::sqrt(18.0) / 65534.0 + 0x1p-21)
            << normal.x << " " << normal.y << " " << normal.z;
        const glm::vec3 again = unpackNormal(packNormal(back));
        ASSERT_EQ(again, back);
    };
    for (int i = 0; i < 100'000; ++i) check(randomDirection(random));
    // Near and on the octahedron's edges and corners, where its lower half is folded out.
    for (int i = 0; i < 20'000; ++i) {
        glm::vec3 v = randomDirection(random);
        v[random.below(3)] = (float) random.pick({0.0, -0.0, 1e-20, -1e-20, 1e-5, -1e-5});
        check(unitVector(v));
    }
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {1.0f, -1.0f}) {
            glm::vec3 v(0.0f);
            v[axis] = side;
            check(v);
            EXPECT_EQ(unpackNormal(packNormal(v)), v);
        }
    EXPECT_GT(worst, 5e-5);
}

TEST(PackedPoint, KeepsTheRestExactly) {
    Random random(3);
    const std::vector<ViewSet> sets = {ViewSet(GridSettings{}, Camera{})};
    NastyTriangles nasty(random, sets);
    for (int i = 0; i < 5'000; ++i) {
        const Triangle t = nasty.next().triangle;
        SurfacePoint point = pointOn(t);
        point.primitive = (uint32_t) random.bits() & 0x7fffffffu;
        point.u = (float) random.uniform();
        point.v = (float) random.uniform() * (1.0f - point.u);
        point.position = interpolate(t.a, t.b, t.c, point.u, point.v);
        if (random.chance(0.5)) point.geometricNormal = -point.geometricNormal;
        point.shadingNormal = point.geometricNormal;
        point.gloss = (uint32_t) random.bits();
        point.roughness = (float) random.uniform();
        const SurfacePoint back = roundTrip(point, t);
        ASSERT_EQ(back.primitive, point.primitive);
        ASSERT_TRUE(sameBits(back.position, point.position));
        ASSERT_TRUE(sameBits(back.geometricNormal, point.geometricNormal));
        ASSERT_TRUE(sameBits(back.shadingNormal, point.shadingNormal));
        ASSERT_TRUE(sameBits(back.u, point.u) && sameBits(back.v, point.v));
        ASSERT_EQ(back.gloss, point.gloss);
        // Half of a step of 1/65535, and a rounding of each of three operations.
        ASSERT_LE(std::abs(back.roughness - point.roughness), 0.5f / 65535.0f + 0x1p-22f);
        const SurfacePoint again = roundTrip(back, t);
        ASSERT_TRUE(sameBits(again, back));
    }
}

/// A ray that leaves an unpacked point begins on the side that the point scatters it to.
TEST(PackedPoint, LetsNoRayThroughItsSurface) {
    Random random(4);
    const std::vector<ViewSet> sets = {ViewSet(GridSettings{}, Camera{})};
    NastyTriangles nasty(random, sets);
    int left = 0;
    for (int i = 0; i < 5'000; ++i) {
        const Triangle t = nasty.next().triangle;
        SurfacePoint point = pointOn(t);
        if (random.chance(0.5)) point.geometricNormal = -point.geometricNormal;
        point.shadingNormal = facing(randomDirection(random), point.geometricNormal);
        const SurfacePoint back = roundTrip(point, t);
        const Scattering next = scatter(back, (float) random.uniform(), (float) random.uniform());
        if (next.direction == glm::vec3(0.0f)) continue;
        const int side = directionSide(next.direction, t.a, t.b, t.c);
        const glm::vec3 origin = offsetOrigin(t, back.u, back.v, next.direction);
        if (side == 0) continue; // no area, or along the surface
        // Where rounding does not leave the side in doubt it is that of the full point's normal.
        if (std::abs(glm::dot(point.geometricNormal, next.direction)) > 1e-5f) {
            const int front = directionSide(point.geometricNormal, t.a, t.b, t.c);
            ASSERT_NE(side, -front); // a needle's normal may lie in its plane
        }
        ASSERT_EQ(planeSide(origin, t.a, t.b, t.c), side);
        ASSERT_TRUE(sameBits(origin, offsetOrigin(t, point.u, point.v, next.direction)));
        ++left;
    }
    EXPECT_GT(left, 1000);
}

TEST(PackedPoint, HasTheWordsThatAreNeeded) {
    Requirements need;
    EXPECT_EQ(pointFormatOf(need).bytes(), 80u);
    need.packedShading = true;
    EXPECT_EQ(pointFormatOf(need).bytes(), PackedPoints::kLeastBytes);
    need.bumps = true;
    EXPECT_EQ(pointFormatOf(need).bytes(), 24u);
    need.shadingNormals = need.emission = need.gloss = true;
    EXPECT_EQ(pointFormatOf(need).bytes(), 32u);

    PackedPoint point;
    point.primitive = 7, point.u = 1, point.v = 2, point.diffuse = 3, point.roughness = 4;
    point.normal = 5, point.emission = 6, point.gloss = 8;
    for (int has = 0; has < 8; ++has) {
        need.bumps = false;
        need.shadingNormals = (has & 1) != 0;
        need.emission = (has & 2) != 0;
        need.gloss = (has & 4) != 0;
        PackedPoints points(pointFormatOf(need), 3);
        ASSERT_EQ(points.size(), 3u);
        for (size_t i = 0; i < 3; ++i) ASSERT_FALSE(points.found(i));
        points.set(1, point);
        PackedPoint expected = point;
        if (!need.shadingNormals) expected.normal = kNormalOfTriangle;
        if (!need.emission) expected.emission = 0;
        if (!need.gloss) expected.gloss = 0;
        EXPECT_TRUE(sameBits(points[1], expected)) << has;
        EXPECT_TRUE(points.found(1));
        EXPECT_FALSE(points.found(0) || points.found(2));
    }
}

} // namespace
} // namespace dirt::test
