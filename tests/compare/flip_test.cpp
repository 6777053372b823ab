// FLIP: against figures of the published implementation, against a plain evaluation of the paper's
// formulas, and in cases that are clear without either.

#include "core/compare/flip.h"

#include "backend_cpu/thread_pool.h"
#include "core/compare/colour.h"
#include "tests/compare/naive_flip.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include <gtest/gtest.h>

namespace dirt::test {
namespace {

constexpr int kWidth = 40, kHeight = 30;

/// Both evaluations work in double: sums of at most 441 products of values that reach 600 have
/// errors below 1e-10, which the exponents 0.7 and 0.5 turn into at most 1e-7 and 1e-6 where the
/// difference itself is zero; the tabulated matrices are good to 1e-9. Measured: 3e-8.
constexpr double kTolerance = 1e-6;

Image filledImage(int width, int height, glm::vec3 colour) {
    return {width, height, std::vector<glm::vec3>((size_t) width * height, colour)};
}

/// The same bytes as the script that gave the figures below: one step of a linear congruential
/// generator on a mixture of the coordinates.
double noise(uint32_t x, uint32_t y, uint32_t channel, uint32_t seed) {
    const uint32_t mixed = x * 73856093u ^ y * 19349663u ^ channel * 83492791u ^ seed * 2654435761u;
    return ((mixed * 1664525u + 1013904223u) >> 24) / 255.0;
}

Image decoded(int width, int height, const std::function<double(int x, int y, int c)>& display) {
    Image image = filledImage(width, height, glm::vec3(0.0f));
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < 3; ++c)
                image.pixels[(size_t) y * width + x][c] = (float) decodeSrgb(display(x, y, c));
    return image;
}

Image noiseImage(int width, int height, uint32_t seed) {
    return decoded(width, height, [=](int x, int y, int c) {
        return noise((uint32_t) x, (uint32_t) y, (uint32_t) c, seed);
    });
}

double rampAt(int x) {
    return std::round(255.0 * x / (kWidth - 1)) / 255.0;
}

Image ramp() {
    return decoded(kWidth, kHeight, [](int x, int, int) { return rampAt(x); });
}

Image rampWithNoise() {
    return decoded(kWidth, kHeight, [](int x, int y, int c) {
        const bool inside = x >= 12 && x < 22 && y >= 10 && y < 20;
        return inside ? noise((uint32_t) x, (uint32_t) y, (uint32_t) c, 1) : rampAt(x);
    });
}

double mean(const Plane& plane) {
    return std::accumulate(plane.values.begin(), plane.values.end(), 0.0) /
           (double) plane.values.size();
}

double largest(const Plane& plane) {
    return *std::max_element(plane.values.begin(), plane.values.end());
}

struct Figures {
    double mean, corner, middle, largest;
};

void expectFigures(const Plane& map, const Figures& expected) {
    EXPECT_NEAR(mean(map), expected.mean, kTolerance);
    EXPECT_NEAR(map.at(0, 0), expected.corner, kTolerance);
    EXPECT_NEAR(map.at(17, 15), expected.middle, kTolerance);
    EXPECT_NEAR(largest(map), expected.largest, kTolerance);
}

Plane flipOf(const Image& a, const Image& b) {
    SerialExecutor serial;
    return flip(a, b, serial);
}

// The expected figures are those of the authors' published Python formulas in float64, with its
// filters as whole two-dimensional sums in NumPy.

TEST(Flip, NoiseAgainstNoiseIsAsPublished) {
    expectFigures(flipOf(noiseImage(kWidth, kHeight, 1), noiseImage(kWidth, kHeight, 2)),
                  {0.467610229498, 0.518234334099, 0.618761089469, 0.958820504226});
}

TEST(Flip, ANoisyPatchInARampIsAsPublished) {
    expectFigures(flipOf(ramp(), rampWithNoise()),
                  {0.069480403546, 0.0, 0.597635392734, 0.769653084962});
}

TEST(Flip, OneWhitePixelIsAsPublished) {
    const Image black = filledImage(kWidth, kHeight, glm::vec3(0.0f));
    Image dot = black;
    dot.pixels[15 * kWidth + 17] = glm::vec3(1.0f);
    expectFigures(flipOf(black, dot), {0.011926315451, 0.0, 0.864906493684, 0.864906493684});
}

TEST(Flip, ConstantColoursAreAsPublished) {
    const auto between = [](glm::vec3 a, glm::vec3 b) {
        const Plane map = flipOf(filledImage(9, 5, a), filledImage(9, 5, b));
        EXPECT_NEAR(*std::min_element(map.values.begin(), map.values.end()), largest(map), 1e-12);
        return map.at(4, 2);
    };
    const glm::vec3 black(0), white(1), red(1, 0, 0), green(0, 1, 0), blue(0, 0, 1);
    EXPECT_NEAR(between(black, white), 0.967379763, kTolerance);
    EXPECT_NEAR(between(red, green), 0.986662275, kTolerance);
    EXPECT_NEAR(between(green, blue), 1.0, kTolerance);
}

/// Black and white differ by 100 in L* alone: 100^0.7 on the upper part of the range, whose end is
/// the distance of green and blue.
TEST(Flip, BlackAgainstWhiteFollowsFromTheFormula) {
    const double farthest = std::pow(
        hyab(huntAdjusted(linearToLab({0, 1, 0})), huntAdjusted(linearToLab({0, 0, 1}))), 0.7);
    const double expected =
        0.95 + 0.05 * (std::pow(100.0, 0.7) - 0.4 * farthest) / (0.6 * farthest);
    const Plane map =
        flipOf(filledImage(1, 1, glm::vec3(0.0f)), filledImage(1, 1, glm::vec3(1.0f)));
    EXPECT_NEAR(map.at(0, 0), expected, 1e-9);
}

TEST(Flip, EqualImagesDifferNowhere) {
    const Image image = noiseImage(23, 31, 3);
    EXPECT_EQ(largest(flipOf(image, image)), 0.0);
}

TEST(Flip, IsSymmetric) {
    const Image a = noiseImage(37, 19, 4), b = noiseImage(37, 19, 5);
    EXPECT_EQ(flipOf(a, b).values, flipOf(b, a).values);
}

TEST(Flip, OneDifferentPixelIsSeenAsFarAsTheFiltersReach) {
    Image a = noiseImage(60, 60, 6), b = a;
    b.pixels[30 * 60 + 30] = glm::vec3(1.0f) - b.pixels[30 * 60 + 30];
    const Plane map = flipOf(a, b);
    EXPECT_GT(map.at(30, 30), 0.1);
    for (int y = 0; y < 60; ++y)
        for (int x = 0; x < 60; ++x) {
            const int far = std::max(std::abs(x - 30), std::abs(y - 30));
            if (far > 10) {
                EXPECT_EQ(map.at(x, y), 0.0) << x << ", " << y;
            }
        }
    EXPECT_GT(map.at(20, 30), 0.0);
}

TEST(Flip, AgreesWithThePlainEvaluationForAnySize) {
    const int sizes[][2] = {{1, 1}, {1, 7}, {9, 1}, {2, 3}, {12, 5}, {25, 26}};
    for (const auto& [width, height] : sizes) {
        const Image a = noiseImage(width, height, 7), b = noiseImage(width, height, 8);
        const Plane map = flipOf(a, b);
        const NaiveFlip naive(a, b);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                EXPECT_NEAR(map.at(x, y), naive.at(x, y), kTolerance)
                    << x << ", " << y << " of " << width << "x" << height;
    }
}

TEST(Flip, GivesTheSameBitsForAnyNumberOfThreads) {
    const Image a = noiseImage(130, 70, 9), b = noiseImage(130, 70, 10);
    ThreadPool three(3);
    EXPECT_EQ(flip(a, b, three).values, flipOf(a, b).values);
}

Image scaledUp(Image image) {
    for (glm::vec3& pixel : image.pixels) pixel = pixel * 8.0f + 0.01f;
    return image;
}

TEST(HdrFlip, IsAsPublished) {
    const Image a = scaledUp(rampWithNoise()), b = scaledUp(ramp());
    const std::vector<double> exposures = hdrExposures(b);
    ASSERT_EQ(exposures.size(), 3u);
    EXPECT_NEAR(exposures.front(), -1.918505584, 1e-6); // 8.01 in float: 6e-8 of a stop
    EXPECT_NEAR(exposures.back(), 0.297462819, 1e-6);
    SerialExecutor serial;
    expectFigures(hdrFlip(a, b, serial), {0.068727736626, 0.0, 0.610693674276, 0.809406786858});
}

TEST(HdrFlip, SeesWhatOneExposureHides) {
    Image a = filledImage(40, 20, glm::vec3(0.01f));
    for (int y = 0; y < 20; ++y)
        for (int x = 25; x < 40; ++x) a.pixels[(size_t) y * 40 + x] = glm::vec3(1000.0f);
    Image b = a;
    b.pixels[10 * 40 + 5] = glm::vec3(0.04f);
    b.pixels[10 * 40 + 35] = glm::vec3(250.0f);
    SerialExecutor serial;
    const Plane map = hdrFlip(a, b, serial);
    EXPECT_GT(map.at(5, 10), 0.1);
    EXPECT_GT(map.at(35, 10), 0.1);
    EXPECT_EQ(map.at(20, 0), 0.0);
}

TEST(HdrFlip, HasExposuresForOddReferences) {
    const Image black = filledImage(3, 3, glm::vec3(0.0f));
    EXPECT_EQ(hdrExposures(black), std::vector<double>{0.0});
    EXPECT_EQ(hdrExposures(filledImage(3, 3, glm::vec3(-1.0f))), std::vector<double>{0.0});
    EXPECT_EQ(hdrExposures(filledImage(3, 3, glm::vec3(2.0f))).size(), 1u);

    Image mostlyBlack = black; // median 0: that of the positive ones, 1 and 4, takes its place
    mostlyBlack.pixels[0] = glm::vec3(1.0f);
    mostlyBlack.pixels[8] = glm::vec3(4.0f);
    const std::vector<double> exposures = hdrExposures(mostlyBlack);
    EXPECT_NEAR(exposures.back() - exposures.front(), std::log2(4.0 / 2.5), 1e-6);

    SerialExecutor serial;
    Image extreme = black;
    extreme.pixels[4] = glm::vec3(3e38f);
    extreme.pixels[5] = glm::vec3(1e-38f);
    for (double value : hdrFlip(black, extreme, serial).values) {
        EXPECT_GE(value, 0.0);
        EXPECT_LE(value, 1.0);
    }
}

} // namespace
} // namespace dirt::test
