// What the derivations of the CPU backend's margins need, counted anew (see
// tests/grid/margins_test).

#include "core/grid/view.h"

#include "shaders/shared/margins.h"

#include <gtest/gtest.h>

namespace dirt::test {
namespace {

constexpr double u = 0x1p-24, v = 0x1p-53; // a rounding to float, to double

TEST(CpuMargins, HoldWhatTheWalkNeeds) {
    // Crossings through one reciprocal: four roundings; moved, one more.
    EXPECT_GE(kVisitSlack, 4 * v + v);
    // 2^-50 of slope over the least depth: less than 1/1024 of a tile.
    EXPECT_LE(0x1p-50 / kNearestWalked, 2.0 / kMaxTiles / 1024);
    // Depths: as much, and a rounding to float.
    EXPECT_LE(0x1p-50 / kNearestWalked + u, kVisitDepthSlack);
    EXPECT_GE(kPartSlack, u + v);
}

TEST(CpuMargins, HoldWhatLeavesNeed) {
    EXPECT_GT(kBoxPad * 8, 4 * u * 6);
    EXPECT_GT(kBoxPad, 4 * u);
    EXPECT_LT(kLeastDirection * 2, 0.5 * kBoxPad); // moves points less than what is left
    EXPECT_GE(kCellSlack, 7 * u);
    EXPECT_GE(kThinDoubt, 3 * v);
    EXPECT_GT(4 * kLateralError, 30 * u);
    EXPECT_GT(kFinality, u + 0x1p-28);
    EXPECT_GT(kRelativeErrorT, 2 * (u + 0x1p-28));
    EXPECT_LE(v / kSignDoubt, 0x1p-27);
    EXPECT_GT(kDepthMargin, 4.5 * 0x1p-27 + 5 * v);
}

TEST(CpuMargins, HoldWhatTheLightGridNeeds) {
    // P / near places, of slopes of p that are off by 3 places, and half a place at an edge.
    EXPECT_GT(kLightPlaces, 3 + 0.5);
    const double places = 1 / kLightNearest + kLightPlaces;
    EXPECT_LT(1.5 * places * 0x1p-23, kLightRim);
    EXPECT_GT(kLightBelow, 2 * u);
    EXPECT_GT(kLightBeyond, 3 * u);
    EXPECT_GT(kLightConeSlack, 4 * 0x1p-22);
    // LightTriangle: the determinant 24 and 4, an edge 8 a component.
    EXPECT_GT(kLightError, 24 * v);
    EXPECT_GT(kLightNormalError, 4 * v);
    EXPECT_LE(0x1p-48 / kLightEdgeClear, 0.5 * 0x1p-23);
    EXPECT_LE((24 + 8) * v / kLightDepthClear, u);
    // Records: planes in double against their own float rounding.
    EXPECT_GE(kLightRecord, u);
    EXPECT_GE(kLightOwnError, 0x1p-48);
    EXPECT_GE(kLightOwnRounding, 4 * v);
}

} // namespace
} // namespace dirt::test
