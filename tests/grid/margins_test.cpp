// What the derivations of shaders/shared/margins.h need, counted anew: none of the margins that
// core uses is less. Where more than twice as much is there, a half would do, and no other test can
// tell.

#include "core/grid/view.h"

#include "shaders/shared/margins.h"

#include <gtest/gtest.h>

namespace dirt::test {
namespace {

constexpr double u = 0x1p-24, v = 0x1p-53; // a rounding to float, to double

TEST(Margins, HoldWhatCoverageAndClipNeed) {
    // Edge planes: 6 u of rounding, of a corner that stays beyond 1/512 when moved by the guard
    // band; side planes: 3 u n / 2 of a tile.
    const double n = kMaxTiles;
    EXPECT_GT(2.0 * (kGuardBand - 1.0 / 512) / n, 6 * u);
    EXPECT_GT(kGuardBand - 1.0 / 512, 1.5 * u * n);
    EXPECT_LT(kGuardBand + 1.5 * u * n, 1.0 / 64);
    // 2.5 roundings of the terms are 2.5 * 2^-27 of what is above it; an edge has two.
    EXPECT_LE(v / kSignDoubt, 0x1p-27);
    EXPECT_GT(kDepthMargin, 4.5 * 0x1p-27 + 5 * v);
}

TEST(Margins, HoldWhatDecisionsNeed) {
    EXPECT_GT(kRelativeErrorT, 2 * (u + 0x1p-28));
    // Computed t: exact to u + 2^-28 each.
    EXPECT_GT(kFinality, u + 0x1p-28);
    EXPECT_GT(kConeInset, u + 0x1p-28);
    EXPECT_GT(kEdgeError, 14 * v);
    EXPECT_GE(kPlaneDoubt, 14 * v / 0x1p-29);
    // A barycentric weight is off by two errors at most, and by a rounding below 1.
    EXPECT_LT(2 / kSureWeights + u / 2, 0x1p-23);
    EXPECT_GE(kNeedle, 8 * v / 0x1p-20); // a normal to 2^-20
    EXPECT_GT(kOffsetStep, u);
}

TEST(Margins, HoldWhatTheFilterNeeds) {
    EXPECT_GT(kLateralError, 5 * u);
    EXPECT_GT(4 * kLateralError, 30 * u);
    EXPECT_GT(4 * 2 * kLateralError, 48 * u); // in GLSL
}

TEST(Margins, HoldWhatTheWalkNeeds) {
    // A crossing: numerator, denominator, and a quotient to 2.5 ulp. Two parameters are compared,
    // one of them moved; depths are moved.
    EXPECT_GT(kCrossingSlack, 2 * 7 * v + v);
    EXPECT_GT(kCornerDoubt, 2 * v);
    EXPECT_GE(kDepthSlack, 7 * v + v);
}

} // namespace
} // namespace dirt::test
