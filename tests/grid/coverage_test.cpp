#include "core/grid/clip.h"
#include "tests/support/corner_triangles.h"
#include "tests/support/nasty_triangles.h"
#include "tests/support/print.h"

#include <gtest/gtest.h>

#include <cfloat>
#include <map>
#include <string>

// G1 and G2 against the exact clip: what a tile lists, and at which depths.

namespace dirt::test {
namespace {

/// What construction does for one triangle and tile.
struct Listed {
    bool ranged = false, overlaps = false, clipped = false;
    DepthInterval depths;

    Listed(const TileCase& c) {
        ViewTriangle setup;
        if (!setUpTriangle(c.triangle, *c.view, setup)) return;
        const TileRange range = tileRange(setup, *c.view);
        ranged = range.column0 <= c.column && c.column <= range.column1 && range.row0 <= c.row &&
                 c.row <= range.row1;
        overlaps = dirt::overlaps(setup, *c.view, c.column, c.row);
        clipped = clipToTile(setup, *c.view, c.column, c.row, depths);
    }
    bool listed() const { return overlaps && clipped; }
};

/// How far \p f lies outside \p exact, in units of 16 ulp of the exact depth: at most 1 by G2.
/// A depth below FLT_MIN may be flushed.
double excess(const Fraction& exact, float f, double outwards) {
    const double value = exact.value();
    if (value < 2.0 * FLT_MIN) return f <= 2.0f * FLT_MIN ? 0.0 : 99.0;
    const double ulp = std::ldexp(1.0, std::ilogb(value) - 23);
    return (f - value) * outwards / (16.0 * ulp);
}

/// Empty if \p c keeps G1 and G2, else what is wrong.
std::string violation(const TileCase& c) {
    const Listed listed(c);
    const ExactTriangle triangle(c.triangle, *c.view);
    const TileSize tile = c.set->tileSize(*c.view);
    const ExactDepths inner =
        clipExactly(triangle, ExactCone(*c.view, c.column, c.row, tile, 1.0 / 512));

    if (listed.overlaps && !listed.ranged) return "overlaps outside of tileRange";
    if (inner.meets && !listed.overlaps) return "G1: meets 1/512, but overlaps() is false";
    if (inner.meets && !listed.clipped) return "G1: meets 1/512, but clipToTile() is false";
    if (!listed.listed()) return "";
    if (!(listed.depths.near >= 0.0f && listed.depths.near <= listed.depths.far))
        return "an interval that is none: " + hex(listed.depths.near) + " " +
               hex(listed.depths.far);
    if (inner.meets && compare(listed.depths.near, inner.near) > 0)
        return "G1: near " + hex(listed.depths.near) + " > exact " + hex(inner.near.value());
    if (inner.meets && compare(listed.depths.far, inner.far) < 0)
        return "G1: far " + hex(listed.depths.far) + " < exact " + hex(inner.far.value());

    const ExactDepths outer =
        clipExactly(triangle, ExactCone(*c.view, c.column, c.row, tile, 1.0 / 64));
    if (!outer.meets) return "G2: listed, but does not meet 1/64";
    if (excess(outer.near, listed.depths.near, -1) > 1)
        return "G2: near " + hex(listed.depths.near) + " is more than 16 ulp below " +
               hex(outer.near.value());
    if (excess(outer.far, listed.depths.far, +1) > 1)
        return "G2: far " + hex(listed.depths.far) + " is more than 16 ulp above " +
               hex(outer.far.value());
    return "";
}

std::string caseText(const TileCase& c) {
    return describe(*c.set) + " view " + std::to_string(c.view - c.set->views.data()) + " tile (" +
           std::to_string(c.column) + ", " + std::to_string(c.row) + ") " + hex(c.triangle) + " (" +
           c.kind + ")";
}

TEST(Coverage, ListsExactlyWhatTheGuardBandsAskFor) {
    Random random(20161193);
    const std::vector<ViewSet> sets = variousViews(random);
    NastyTriangles triangles(random, sets);
    std::map<std::string, int> failures, kinds;
    int met = 0, total = cases(100'000, 1'000'000);
    for (int i = 0; i < total; ++i) {
        const TileCase c = triangles.next();
        ++kinds[c.kind];
        const std::string wrong = violation(c);
        met += Listed(c).listed();
        if (wrong.empty()) continue;
        int& count = failures[wrong.substr(0, 8) + " (" + c.kind + ")"];
        if (++count <= 2) ADD_FAILURE() << wrong << "\n" << caseText(c);
    }
    for (const auto& [what, count] : failures) ADD_FAILURE() << count << " times " << what;
    // The cases are near the decision: neither almost all nor almost none are listed.
    EXPECT_GT(met, total / 5);
    EXPECT_LT(met, total * 4 / 5);
}

/// The depths are those of the guard-banded tile, rounded outwards.
TEST(Coverage, DepthsHoldThoseOfTheGuardBandedTile) {
    Random random(20161195);
    const std::vector<ViewSet> sets = variousViews(random);
    NastyTriangles triangles(random, sets);
    int listed = 0;
    for (int i = 0; i < cases(20'000, 1'000'000); ++i) {
        const TileCase c = triangles.next();
        ViewTriangle setup;
        DepthInterval depths;
        if (!setUpTriangle(c.triangle, *c.view, setup) ||
            !clipToTile(setup, *c.view, c.column, c.row, depths))
            continue;
        View banded = *c.view;
        banded.s = {c.view->sLo[(size_t) c.column], c.view->sHi[(size_t) c.column]};
        banded.t = {c.view->tLo[(size_t) c.row], c.view->tHi[(size_t) c.row]};
        const ExactDepths exact = clipExactly(ExactTriangle(c.triangle, *c.view),
                                              ExactCone(banded, 0, 0, {0.0, 0.0}, 0.0));
        if (!exact.meets) continue;
        ++listed;
        ASSERT_LE(compare(depths.near, exact.near), 0) << hex(depths.near) << "\n" << caseText(c);
        ASSERT_GE(compare(depths.far, exact.far), 0) << hex(depths.far) << "\n" << caseText(c);
    }
    EXPECT_GT(listed, 2'000);
}

/// Cones are wider by 1/128 of a tile, not by anything that G1 and G2 would allow as well.
TEST(Coverage, ListsWhatMeetsTheGuardBand) {
    const ViewSet set = fullViews(64, 1);
    const View& view = set.views[4]; // its frame is the grid's
    const double tile = 2.0 / 64;
    const auto isListed = [&](double x) {
        const glm::vec3 p((float) x, 0.01f, 1.0f);
        return Listed({&set, &view, {p, p, p}, 40, 32, ""}).listed();
    };
    const double low = 40 * tile - 1.0, high = low + tile;
    for (const double beyond : {1.0 / 128 - 1.0 / 4096, 1.0 / 256 + 1.0 / 4096}) {
        EXPECT_TRUE(isListed(low - beyond * tile)) << beyond;
        EXPECT_TRUE(isListed(high + beyond * tile)) << beyond;
    }
    const double beyond = 1.0 / 128 + 1.0 / 4096;
    EXPECT_FALSE(isListed(low - beyond * tile));
    EXPECT_FALSE(isListed(high + beyond * tile));
}

/// Depths are moved by 2^-22 even where they are exact: these are the bits of every backend.
TEST(Coverage, MovesDepthsOutwards) {
    const ViewSet set = fullViews(1, 1);
    const TileCase c{&set, &set.views[4], {{0, 0, 1}, {0.5f, 0, 1.5f}, {0, 0.5f, 1.25f}}, 0, 0, ""};
    const DepthInterval depths = Listed(c).depths;
    EXPECT_EQ(depths.near, 1.0f - 0x1p-22f);
    EXPECT_EQ(depths.far, 1.5f + 1.5f * 0x1p-22f);
}

/// An edge that leaves the guard band at a depth of 3/4 and 2^-65 of that more, which double does
/// not see: the depths hold it.
TEST(Coverage, DepthsHoldWhatRoundingHides) {
    const ViewSet set = fullViews(2, 1);
    const View& view = set.views[4];
    const Triangle triangle{
        {-0x1p-70f, 0.0f, 0.5f}, {3 * 0x1p-8f, 0.0f, 1.0f}, {-0x1p-8f, 0x1p-4f, 0.25f}};
    const TileCase c{&set, &view, triangle, 0, 1, ""};
    View banded = view;
    banded.s = {view.sLo[0], view.sHi[0]};
    banded.t = {view.tLo[1], view.tHi[1]};
    const ExactDepths exact =
        clipExactly(ExactTriangle(triangle, view), ExactCone(banded, 0, 0, {0.0, 0.0}, 0.0));
    ASSERT_TRUE(exact.meets);
    EXPECT_GT(compare(std::nextafter(0.75f, 1.0f), exact.far), 0);
    EXPECT_LT(compare(0.75f, exact.far), 0);
    EXPECT_GT(compare(Listed(c).depths.far, exact.far), 0);
}

TEST(Coverage, DecidesEdgesThroughCornersExactly) {
    Random random(20161194);
    for (int round = 0; round < cases(30, 300); ++round) {
        const ViewSet set = fullViews(random.range(4, 40), random.pick({1, 3}));
        for (int i = 0; i < 1000; ++i) {
            const View& view = set.views[(size_t) random.below(6)];
            const CornerTriangle corner = throughCorner(random, view);
            const TileCase c{&set,          &view,      corner.triangle,
                             corner.column, corner.row, "through a corner"};
            ASSERT_EQ(violation(c), "") << caseText(c);
        }
    }
}

} // namespace
} // namespace dirt::test
