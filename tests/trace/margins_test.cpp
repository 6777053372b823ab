// Crossings of borders against exact ones, where a margin that is too small shows: hits alone would
// not tell.

#include "core/trace/view_ray.h"
#include "core/trace/view_walk.h"
#include "tests/support/exact_point.h"
#include "tests/support/grid_rays.h"
#include "tests/support/print.h"

#include <gtest/gtest.h>

#include <optional>

namespace dirt::test {
namespace {

/// The later (or earlier) of two parameters.
void keep(std::optional<Fraction>& best, const Fraction& t, int wanted) {
    if (!best || compare(t, *best) * wanted > 0) best = t;
}

TEST(ViewRay, SpansHoldTheExactOnes) {
    Random random(51);
    int spans = 0;
    for (int i = 0; i < cases(20'000, 1'000'000); ++i) {
        const ViewSet set = random.chance(0.5) ? fullViews(random.range(1, 20), 1)
                                               : singleView(random.range(1, 40), 17, 1, 53.0f);
        const View& view = set.views[(size_t) random.below((int) set.views.size())];
        const Ray ray = GridRays(random, set).next().ray;
        ViewSpan span;
        if (!ViewRay(view, ray).clip(0, span)) continue;
        const ExactRay exact(ray);
        const ExactCone cone(view, TileRange{0, view.columns - 1, 0, view.rows - 1}, {0, 0}, 0);
        const auto o = cone.distances(ExactRay::toView(view, exact.origin));
        const auto d = cone.distances(ExactRay::toView(view, exact.direction));
        std::optional<Fraction> begin, end;
        for (int side = 0; side < 4; ++side) {
            if (d[side] == 0) continue;
            const Fraction t{-o[side] * sign(d[side]), abs(d[side]),
                             exact.unit - exact.directionUnit};
            if (d[side] > 0)
                keep(begin, t, 1);
            else
                keep(end, t, -1);
        }
        if (span.begin > 0.0) {
            ASSERT_TRUE(begin.has_value() && compare(span.begin, *begin) <= 0)
                << hex(span.begin) << "\n"
                << hex(ray);
        }
        if (end) {
            ASSERT_GE(compare(span.end, *end), 0) << hex(span.end) << "\n" << hex(ray);
        }
        ++spans;
    }
    EXPECT_GT(spans, 2'000);
}

/// T2: the depths of a tile's visit hold those of the ray in it, here one that double does not see.
TEST(ViewRay, VisitsHoldTheExactDepths) {
    const ViewSet set = fullViews(2, 1);
    const View& view = set.views[4]; // its frame is the grid's
    DepthPyramid pyramid = makeEmptyGrid(set.camera, set.settings).pyramids[4];
    for (DepthBounds& bounds : pyramid.levels[0].bounds) bounds = {0.0f, 4.0f};
    buildPyramid(pyramid);
    for (const float dw : {-1.0f, 1.0f}) {
        // x = 0 is crossed at a depth of 1 and 2^-60 less or more.
        const Ray ray{{0x1p-60f, 0.25f, 1.0f}, {-1.0f, 0.0f, dw}, kNoPrimitive};
        const ViewRay seen(view, ray);
        ViewSpan span;
        ASSERT_TRUE(seen.clip(4, span));
        ViewWalk walk(seen, span, pyramid, 0);
        const double forever = INFINITY;
        int visits = 0;
        walk.run(
            forever, [](const CellLook&) {},
            [&](const TileVisit& visit) {
                if (visits++ > 0) return;
                EXPECT_EQ(visit.tile, 3);
                if (dw < 0.0f) {
                    EXPECT_LT(visit.near, 1.0f);
                } else {
                    EXPECT_GT(visit.far, 1.0f);
                }
            });
        EXPECT_GT(visits, 0);
    }
}

/// Rays through a corner of tiles, and an ulp beside it: which border comes first is told only
/// where that is certain.
TEST(ViewRay, TellsTheOrderOfBordersOnlyWhereItIsCertain) {
    Random random(52);
    int told = 0;
    for (int i = 0; i < cases(100'000, 1'000'000); ++i) {
        static const ViewSet sets[] = {fullViews(17, 1), fullViews(37, 3),
                                       singleView(51, 33, 1, 40.0f)};
        const ViewSet& set = sets[random.below(3)];
        const View& view = set.views[0];
        const float s = view.s[(size_t) random.below(view.columns + 1)];
        const float t = view.t[(size_t) random.below(view.rows + 1)];
        const glm::vec3 corner(s, t, 1.0f);
        glm::vec3 off, origin;
        for (int k = 0; k < 3; ++k) { // multiples of an ulp: the sum is exact
            const float ulp = std::nextafter(std::abs(corner[k]), 4.0f) - std::abs(corner[k]);
            off[k] = ulp * (float) random.range(-1'000'000, 1'000'000);
            origin[k] = corner[k] + off[k];
        }
        if (random.chance(0.5)) { // beside it, by little
            float& x = origin[random.below(3)];
            x = std::nextafter(x, random.chance(0.5) ? 9.0f : -9.0f);
        }
        const Ray ray{fromView(view, origin), fromView(view, -off), kNoPrimitive};
        const ViewRay seen(view, ray);
        const int order = orderOf(seen, s, t);
        const ExactRay exact(ray);
        const int unit = std::min({lowestExponent(s), lowestExponent(t), 0});
        const IntegerVector o = ExactRay::toView(view, exact.origin);
        const IntegerVector d = ExactRay::toView(view, exact.direction);
        const int side = sign(dot(cross(o, d), toIntegers(corner, unit)));
        if (order == 0) continue;
        ASSERT_EQ(order, side * seen.step.x * seen.step.y) << hex(ray);
        ++told;
    }
    EXPECT_GT(told, 10'000);
}

} // namespace
} // namespace dirt::test
