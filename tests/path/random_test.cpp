#include "shaders/shared/random.h"

#include "core/path/camera_rays.h"
#include "tests/path/chi_square.h"

#include <gtest/gtest.h>

namespace dirt {
namespace {

using test::chiSquareP;
using test::kGreatestP;
using test::kLeastP;

// Values of the published definition, computed with Python's integers.
TEST(Random, Pcg4dHasThePublishedValues) {
    EXPECT_EQ(pcg4d({0, 0, 0, 0}), glm::uvec4(0x0f02f829, 0x2d568769, 0x32b0c43b, 0xd32548ea));
    EXPECT_EQ(pcg4d({1, 2, 3, 4}), glm::uvec4(0x3622cd16, 0xf11471d8, 0xe1109b3f, 0x02b94c2f));
    EXPECT_EQ(pcg4d(glm::uvec4(0xffffffff)),
              glm::uvec4(0x974ed892, 0xc015dc67, 0x9f955760, 0xa1bba208));
}

TEST(Random, UnitIsTheHighBitsOfTheFirstWord) {
    EXPECT_EQ(randomUnit(123456, 15, 2, 1, 7), (float) (0xf7ea4ece >> 8) / 16777216.0f);
}

TEST(Random, UnitIsBelowOne) {
    for (uint pixel = 0; pixel < 1000000; ++pixel) {
        const float u = randomUnit(pixel, 0, 1, 0, 0);
        ASSERT_TRUE(u >= 0.0f && u < 1.0f) << pixel;
    }
}

/// Chi-square of 2^18 numbers in 256 bins; \p draw(i) gives the i-th.
template <typename Draw>
double uniformP(const Draw& draw) {
    const int count = 1 << 18, bins = 256;
    std::vector<double> counts(bins, 0.0);
    for (int i = 0; i < count; ++i) counts[(int) (draw((uint) i) * bins)] += 1.0;
    return chiSquareP(counts, std::vector<double>(bins, (double) count / bins));
}

TEST(Random, UniformAlongEveryArgument) {
    const double p[] = {
        uniformP([](uint i) { return randomUnit(i, 3, 1, 0, 0); }),
        uniformP([](uint i) { return randomUnit(77, i, 1, 0, 0); }),
        uniformP([](uint i) { return randomUnit(77, 3, i >> 8, i & 255, 0); }),
        uniformP([](uint i) { return randomUnit(77, 3, 1, 0, i); }),
    };
    for (int argument = 0; argument < 4; ++argument) {
        EXPECT_GT(p[argument], kLeastP) << argument;
        EXPECT_LT(p[argument], kGreatestP) << argument;
    }
}

/// The same for pairs in 32 x 32 bins.
template <typename Draw>
double pairP(const Draw& draw) {
    const int count = 1 << 18, bins = 32;
    std::vector<double> counts(bins * bins, 0.0);
    for (int i = 0; i < count; ++i) {
        const glm::vec2 pair = draw((uint) i);
        counts[(int) (pair.x * bins) * bins + (int) (pair.y * bins)] += 1.0;
    }
    return chiSquareP(counts, std::vector<double>(bins * bins, (double) count / (bins * bins)));
}

TEST(Random, NeighboursAreIndependent) {
    const double p[] = {
        // two dimensions of one event, two events, two samples, two pixels, two seeds
        pairP(
            [](uint i) { return glm::vec2(randomUnit(i, 0, 1, 0, 0), randomUnit(i, 0, 1, 1, 0)); }),
        pairP(
            [](uint i) { return glm::vec2(randomUnit(i, 0, 1, 0, 0), randomUnit(i, 0, 2, 0, 0)); }),
        pairP(
            [](uint i) { return glm::vec2(randomUnit(i, 0, 1, 0, 0), randomUnit(i, 1, 1, 0, 0)); }),
        pairP([](uint i) {
            return glm::vec2(randomUnit(i, 0, 1, 0, 0), randomUnit(i + 1, 0, 1, 0, 0));
        }),
        pairP(
            [](uint i) { return glm::vec2(randomUnit(i, 0, 1, 0, 0), randomUnit(i, 0, 1, 0, 1)); }),
    };
    for (int pair = 0; pair < 5; ++pair) {
        EXPECT_GT(p[pair], kLeastP) << pair;
        EXPECT_LT(p[pair], kGreatestP) << pair;
    }
}

TEST(Random, SubPixelOffsetsFillThePixel) {
    const double p = pairP([](uint i) { return subPixelOffset(i, 0); });
    EXPECT_GT(p, kLeastP);
    EXPECT_LT(p, kGreatestP);
    EXPECT_NE(subPixelOffset(0, 0), subPixelOffset(0, 1));
}

} // namespace
} // namespace dirt
