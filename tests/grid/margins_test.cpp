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
    // Edge planes: 17 u of rounding, of a corner that stays beyond 1/512 when moved by the guard
    // band; side planes: 3 u n / 2 of a tile.
    const double n = kMaxTiles;
    EXPECT_GT(2.0 * (kGuardBand - 1.0 / 512) / n, 17 * u);
    EXPECT_GT(kGuardBand - 1.0 / 512, 1.5 * u * n);
    EXPECT_LT(kGuardBand + 1.5 * u * n, 1.0 / 64);
    // Four roundings of terms; what is above it has a relative error of 2^-24.
    EXPECT_GE(kSignDoubt, 4 * v / u);
    // Two factors off by 2^-24 each, and a division.
    EXPECT_GT(kDepthMargin, 2 * u + 3 * v);
}

TEST(Margins, HoldWhatDecisionsNeed) {
    EXPECT_GT(kRelativeErrorT, 2 * (u + 0x1p-28));
    // Computed t: exact to u + 2^-28 each. Twice err(t) is twice what two of them are apart.
    EXPECT_GT(kFinality, u + 0x1p-28);
    EXPECT_GT(kConeInset, u + 0x1p-28);
    EXPECT_GT(kEdgeError, 14 * v);
    EXPECT_GT(kSideError, 14 * v);
    EXPECT_GE(kPlaneDoubt, 14 * v / 0x1p-29);
    // A weight is off by one error, their sum by three: less than 2^-22 of it.
    EXPECT_GT(kSureWeights, 4 / 0x1p-22);
    EXPECT_GE(kNeedle, 8 * v / 0x1p-20); // a normal to 2^-20
    EXPECT_GT(kOffsetStep, u);
}

TEST(Margins, HoldWhatTheFilterNeeds) {
    EXPECT_GT(kLateralError, 6 * u);
    EXPECT_GT(4 * kLateralError, 24 * u);
    EXPECT_GT(kAreaError, 4 * u);
}

TEST(Margins, HoldWhatTheWalkNeeds) {
    // A crossing: numerator, denominator, quotient; two are compared, one of them moved.
    EXPECT_GT(kCrossingSlack, 2 * 4 * v);
    EXPECT_GT(kCornerDoubt, 4 * v);
    EXPECT_GT(kDepthSlack, 2 * 4 * v);
}

} // namespace
} // namespace dirt::test
