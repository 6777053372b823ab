#include "core/scene/transform.h"
#include "tests/scene/apply.h"

#include <gtest/gtest.h>

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

namespace dirt {
namespace {

TEST(Transform, ScalesThenTurnsThenMoves) {
    const glm::dmat4 m = placement({2, 3, 4}, rotationMatrix({90, {0, 1, 0}}), {10, 20, 30});
    // About +Y, +X turns to -Z and +Z to +X.
    EXPECT_EQ(test::apply(m, {1, 0, 0}), glm::dvec3(10, 20, 28));
    EXPECT_EQ(test::apply(m, {0, 1, 0}), glm::dvec3(10, 23, 30));
    EXPECT_EQ(test::apply(m, {0, 0, 1}), glm::dvec3(14, 20, 30));
}

TEST(Transform, QuarterTurnsAreExact) {
    const glm::dvec3 expected[] = {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
    for (int quarters = -9; quarters <= 9; ++quarters)
        EXPECT_EQ(
            test::apply(placement(glm::dvec3(1), rotationMatrix({90.0 * quarters, {0, 0, 5}}), {}),
                        {1, 0, 0}),
            expected[((quarters % 4) + 4) % 4])
            << quarters;
}

TEST(Transform, TurnsAboutAnyAxis) {
    // A third of a turn about (1, 1, 1) permutes the axes. Sine, cosine and the axis carry half an
    // ulp each and Rodrigues' formula sums three products: 8 ulp hold them.
    const glm::dmat4 m = placement(glm::dvec3(1), rotationMatrix({120, {1, 1, 1}}), {});
    EXPECT_LT(glm::length(test::apply(m, {1, 0, 0}) - glm::dvec3(0, 1, 0)), 8 * 0x1p-52);
    EXPECT_LT(glm::length(test::apply(m, {0, 1, 0}) - glm::dvec3(0, 0, 1)), 8 * 0x1p-52);
    EXPECT_LT(glm::length(test::apply(m, {0, 0, 1}) - glm::dvec3(1, 0, 0)), 8 * 0x1p-52);
}

} // namespace
} // namespace dirt
