// The origin of scenes that are far from 0.

#include "core/scene/origin.h"

#include <gtest/gtest.h>

#include <cfloat>

namespace dirt {
namespace {

Bounds box(glm::dvec3 low, glm::dvec3 high) {
    return {low, high};
}

TEST(Origin, IsZeroWhereFloatsResolveTheScene) {
    EXPECT_EQ(originFor(Bounds()), glm::dvec3(0.0));
    EXPECT_EQ(originFor(box({-78, -3, -1274}, {2390, 88, 43})), glm::dvec3(0.0));
    EXPECT_EQ(originFor(box({0, 0, 0}, {1, 1, 1})), glm::dvec3(0.0));
    // The diagonal of a line of length 1 may be 128 times as far away, and no farther.
    EXPECT_EQ(originFor(box({127, 0, 0}, {128, 0, 0})), glm::dvec3(0.0));
    EXPECT_NE(originFor(box({128, 0, 0}, {129, 0, 0})), glm::dvec3(0.0));
    // At any scale.
    for (const double scale : {0x1p-120, 0x1p-20, 0x1p20, 0x1p120}) {
        EXPECT_EQ(originFor(box({127 * scale, 0, 0}, {128 * scale, 0, 0})), glm::dvec3(0.0));
        EXPECT_NE(originFor(box({129 * scale, 0, 0}, {130 * scale, 0, 0})), glm::dvec3(0.0));
    }
    // A point has no digits to lose.
    EXPECT_EQ(originFor(box({5, 5, 5}, {5, 5, 5})), glm::dvec3(0.0));
    // Far and near parts together make a large scene.
    EXPECT_EQ(originFor(box({0, 0, 0}, {5e5, 5.4e6, 313})), glm::dvec3(0.0));
}

TEST(Origin, LiesOnALatticeAsWideAsTheScene) {
    EXPECT_EQ(originFor(box({500000.1, 5400000.3, 312.4}, {500001.1, 5400001.3, 313.4})),
              glm::dvec3(500000, 5400000, 312));
    // A scene that begins or has its middle at a multiple of the step is as it would be at 0.
    for (const double far : {4096.0, -8192.0, 1048576.0}) {
        EXPECT_EQ(originFor(box({far, 0, 0}, {far + 5, 5, 5})), glm::dvec3(far, 0, 0));
        EXPECT_EQ(originFor(box({far - 3, -3, -3}, {far + 3, 3, 3})), glm::dvec3(far, 0, 0));
    }
    // No coordinate is farther than the lattice's half step and half the edge.
    for (double far = 1000.0; far < 1e12; far *= 1.7) {
        const glm::dvec3 origin = originFor(box({far, -far, far / 3}, {far + 5, 5 - far, far / 3}));
        for (int i = 0; i < 3; ++i) {
            const double low = i == 1 ? -far : i == 0 ? far : far / 3;
            EXPECT_LE(std::abs(low - origin[i]), 1.5 * 5.0 + 1e-3) << far;
        }
    }
}

} // namespace
} // namespace dirt
