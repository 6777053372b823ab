// What the derivations of the CPU backend's margins need, counted anew (see
// tests/grid/margins_test).

#include "core/grid/view.h"

#include "shaders/shared/margins.h"

#include <gtest/gtest.h>

namespace dirt::test {
namespace {

constexpr double u = 0x1p-24, v = 0x1p-53; // a rounding to float, to double

TEST(CpuMargins, HoldWhatTheWalkNeeds) {
    // Crossings through one reciprocal are good for 2^-50; two are compared.
    EXPECT_GE(kCrossingSlack, 0x1p-50);
    EXPECT_GE(kVisitSlack, 2 * 0x1p-50);
    // Depths: 2^-23, and a rounding to float.
    EXPECT_GT(kVisitDepthSlack, 0x1p-23 + u);
    // 2^-49 of slope over the least depth: less than 1/1024 of a tile.
    EXPECT_LE(0x1p-49 / kNearestWalked, 2.0 / kMaxTiles / 1024);
    EXPECT_GT(kPartSlack, u);
}

TEST(CpuMargins, HoldWhatLeavesNeed) {
    EXPECT_GT(kBoxPad * 8, 4 * u * 6);
    EXPECT_GT(kBoxPad, 4 * u);
    EXPECT_LT(kLeastDirection * 2, 0.5 * kBoxPad); // moves points less than what is left
    EXPECT_GE(kCellSlack, 4 * u);
    EXPECT_GT(kThinDoubt, 0x1p-51);
    EXPECT_GT(kLateralError, 6 * u);
    EXPECT_GT(kAreaError, 4 * u);
    EXPECT_GT(kFinality, u + 0x1p-28);
    EXPECT_GE(kSignDoubt, 4 * v / u);
    EXPECT_GT(kDepthMargin, 2 * u + 3 * v);
}

TEST(CpuMargins, HoldWhatTheLightGridNeeds) {
    // P / near places, of slopes of p that are off by 3 places, and half a place at an edge.
    EXPECT_GT(kLightGuard, 4 * u);
    EXPECT_GT(kLightPlaces, 3 + 0.5);
    const double places = (1 + kLightGuard) / kLightNearest + kLightPlaces;
    EXPECT_LT(1.5 * places * 0x1p-23, kLightRim);
    EXPECT_GT(kLightBelow, 2 * u);
    EXPECT_GT(kLightBeyond, 2 * u);
    EXPECT_GT(kLightConeSlack, 4 * 0x1p-22);
    // LightTriangle: the determinant 24 and 4, an edge 8.
    EXPECT_GT(kLightError, 24 * v);
    EXPECT_GT(kLightNormalError, 4 * v);
    EXPECT_LE(0x1p-48 / kLightEdgeClear, 0.5 * 0x1p-23);
    EXPECT_LE((24 + 8) * v / kLightDepthClear, u);
    // Records: planes in double against their own float rounding.
    EXPECT_GE(kLightRecord, u);
    EXPECT_GE(kLightOwnError, 0x1p-48);
    EXPECT_GE(kLightOwnRounding, 4 * v);
    EXPECT_GT(kLightScaleClear, kLightError);
}

} // namespace
} // namespace dirt::test
