// What is told of a ray is what the ray does.

#include "core/explain/ray_trail.h"

#include "tests/support/nasty_rays.h"
#include "tests/support/small_scenes.h"

#include <gtest/gtest.h>

namespace dirt {
namespace {

using namespace test;

struct Soup {
    FrameGeometry geometry;
    Grid grid;

    explicit Soup(Precision precision = Precision::exact, int tile = 8) {
        Random random(7);
        addSoup(random, geometry.triangles, 200);
        addRoom(random, geometry.triangles);
        GridSettings settings;
        settings.viewSize = 64;
        settings.tile = tile;
        settings.bins = 4;
        settings.precision = precision;
        grid = buildGrid(geometry, Camera(), settings);
    }
};

Ray randomRay(Random& random) {
    return {uniformPoint(random, 0.9), uniformPoint(random, 1.0)};
}

/// All tests of a trail in their order.
std::vector<TriangleTrail> testsOf(const RayTrail& trail) {
    std::vector<TriangleTrail> tests = trail.atEye;
    for (const ViewTrail& view : trail.views)
        for (const TileTrail& tile : view.tiles)
            for (const BinTrail& bin : tile.bins)
                tests.insert(tests.end(), bin.triangles.begin(), bin.triangles.end());
    return tests;
}

TEST(RayTrail, EndsInTheHitAndCountsEverything) {
    const Soup soup;
    Random random(1);
    size_t found = 0;
    for (int i = 0; i < 500; ++i) {
        const Ray ray = randomRay(random);
        const RayTrail trail = closestTrail(soup.grid, soup.geometry, ray);
        const Hit hit = closestHit(soup.grid, soup.geometry, ray);
        ASSERT_EQ(trail.hit.primitive, hit.primitive);
        ASSERT_EQ(trail.hit.t, hit.t);
        size_t cells = 0, tiles = 0, bins = 0;
        for (const ViewTrail& view : trail.views) {
            cells += view.cells.size();
            tiles += view.tiles.size();
            for (const TileTrail& tile : view.tiles) bins += tile.bins.size();
        }
        ASSERT_EQ(cells, trail.counts.steps);
        ASSERT_EQ(tiles, trail.counts.tiles);
        ASSERT_EQ(bins, trail.counts.bins);
        const auto tests = testsOf(trail);
        ASSERT_EQ(tests.size(), trail.counts.tests);
        // The last that was nearest is the hit.
        uint32_t nearest = kNoPrimitive;
        for (const TriangleTrail& test : tests)
            if (test.result == Tested::nearest) nearest = test.id;
        ASSERT_EQ(nearest, hit.primitive);
        found += hit.found();
    }
    EXPECT_GT(found, 100u);
    EXPECT_LT(found, 500u);
}

TEST(RayTrail, OfAnyHitEndsInTheBlocker) {
    const Soup soup;
    Random random(2);
    size_t blocked = 0;
    for (int i = 0; i < 500; ++i) {
        const Ray ray = randomRay(random);
        const RayTrail trail = anyTrail(soup.grid, soup.geometry, ray, 0.5f);
        ASSERT_EQ(trail.blocked, anyHit(soup.grid, soup.geometry, ray, 0.5f));
        const auto tests = testsOf(trail);
        ASSERT_EQ(trail.blocked, !tests.empty() && tests.back().result == Tested::nearest);
        blocked += trail.blocked;
    }
    EXPECT_GT(blocked, 50u);
    EXPECT_LT(blocked, 450u);
}

/// The reason that is given for a miss is true, by signs that are counted anew.
TEST(RayTrail, SaysWhyATriangleIsMissed) {
    const Soup soup;
    Random random(3);
    size_t reasons[6] = {};
    for (int i = 0; i < 500; ++i) {
        const Ray ray = randomRay(random);
        for (const TriangleTrail& test : testsOf(closestTrail(soup.grid, soup.geometry, ray))) {
            if (test.result != Tested::missed) continue;
            ++reasons[(size_t) test.refusal.reason];
            const Triangle& t = soup.geometry.triangles[test.id];
            TriangleHit hit;
            ASSERT_FALSE(intersect(ray, t, hit));
            const int signs[] = {test.refusal.a, test.refusal.b, test.refusal.c};
            const bool mixed =
                *std::min_element(signs, signs + 3) < 0 && *std::max_element(signs, signs + 3) > 0;
            switch (test.refusal.reason) {
            case Refusal::Reason::filter:
            case Refusal::Reason::beside:
                ASSERT_TRUE(mixed);
                break;
            case Refusal::Reason::behind: {
                ASSERT_FALSE(mixed);
                Ray back = ray;
                back.direction = -ray.direction;
                ASSERT_TRUE(intersect(back, t, hit));
                break;
            }
            default:
                FAIL() << "reason " << (int) test.refusal.reason;
            }
        }
    }
    EXPECT_GT(reasons[(size_t) Refusal::Reason::filter], 100u);
    EXPECT_GT(reasons[(size_t) Refusal::Reason::behind], 10u);
}

TEST(RayTrail, KnowsRaysInPlanesAndTheFloatTest) {
    const Triangle triangle{{-1, 0, -2}, {1, 0, -2}, {0, 0, -4}};
    const Refusal inPlane = refusalOf({{0, 0, 0}, {0, 0, -1}}, triangle, Precision::exact);
    EXPECT_EQ(inPlane.reason, Refusal::Reason::inPlane);
    EXPECT_EQ(std::abs(inPlane.a) + std::abs(inPlane.b) + std::abs(inPlane.c), 0);
    const Ray beside{{0, 1, 0}, {0, 0, -1}};
    EXPECT_EQ(refusalOf(beside, triangle, Precision::fast).reason, Refusal::Reason::floatTest);
    const Ray meets{{0, 1, -3}, {0, -1, 0}};
    EXPECT_EQ(refusalOf(meets, triangle, Precision::exact).reason, Refusal::Reason::none);
}

} // namespace
} // namespace dirt
