#include "shaders/shared/random.h"

#include "core/path/sub_pixel.h"
#include "tests/path/chi_square.h"

#include <algorithm>
#include <cmath>
#include <set>

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

constexpr uint32_t kSeeds[] = {0, 1, 2, 12345, 0xffffffff};

/// Of the first 2^n samples each box of area 2^-n holds one, whatever its sides.
TEST(SubPixelOffset, EachElementaryBoxHoldsOneSample) {
    for (const uint32_t seed : kSeeds)
        for (int n = 0; n <= 10; ++n)
            for (int columns = 0; columns <= n; ++columns) {
                std::vector<bool> taken((size_t) 1 << n);
                for (uint32_t sample = 0; sample < taken.size(); ++sample) {
                    const glm::vec2 offset = subPixelOffset(sample, seed);
                    const auto column = (size_t) std::ldexp(offset.x, columns);
                    const auto row = (size_t) std::ldexp(offset.y, n - columns);
                    const size_t box = (row << columns) + column;
                    ASSERT_TRUE(box < taken.size() && !taken[box]) << seed << " " << sample;
                    taken[box] = true;
                }
            }
}

/// The error of the part of a pixel before an edge along an axis, the root of its mean square over
/// all edges. Between neighbouring samples the estimate is k / N and the error linear.
double edgeError(uint32_t seed, int axis, uint32_t samples) {
    std::vector<double> places = {0.0, 1.0};
    for (uint32_t i = 0; i < samples; ++i) places.push_back(subPixelOffset(i, seed)[axis]);
    std::sort(places.begin(), places.end());
    double sum = 0.0;
    for (uint32_t k = 0; k <= samples; ++k) {
        const double part = (double) k / samples;
        sum += (std::pow(places[k + 1] - part, 3) - std::pow(places[k] - part, 3)) / 3.0;
    }
    return std::sqrt(sum);
}

// Squared and times N^2, a sample at u of its stratum counts for 1/3 - u (1 - u). Of 4 samples all
// are at 7/16 and on, up to 15/32; of 16 a quarter is at 3/4 or 1/4, of 64 a sixteenth at a border.
TEST(SubPixelOffset, EdgesAreOffByNearlyTheLeastThereIs) {
    for (const uint32_t seed : kSeeds)
        for (const int axis : {0, 1}) {
            EXPECT_LE(edgeError(seed, axis, 4), 0.0739);
            EXPECT_LE(edgeError(seed, axis, 16), 0.0200);
            EXPECT_LE(edgeError(seed, axis, 64), 0.0054);
            EXPECT_LE(edgeError(seed, axis, 256), 0.0014);
        }
}

TEST(SubPixelOffset, SeedsDiffer) {
    std::set<std::pair<float, float>> found;
    for (uint32_t seed = 0; seed < 100; ++seed) {
        const glm::vec2 offset = subPixelOffset(5, seed);
        found.insert({offset.x, offset.y});
    }
    EXPECT_GT(found.size(), 90u);
}

} // namespace
} // namespace dirt
