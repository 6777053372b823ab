// The plain figures, on images small enough to compute them by hand; the colours of the map.

#include "core/compare/differences.h"

#include "core/compare/colour.h"
#include "core/compare/colour_map.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace dirt::test {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

TEST(Differences, AreThoseComputedByHand) {
    const Image a{2, 1, {{0.5f, 0.0f, 1.0f}, {0.25f, 0.25f, 0.25f}}};
    const Image b{2, 1, {{0.5f, 0.5f, 1.0f}, {0.25f, 0.0f, 0.25f}}};
    const Differences d = differencesOf(a, b);
    EXPECT_EQ(d.pixels, 2u);
    EXPECT_DOUBLE_EQ(d.rmse, std::sqrt((0.25 + 0.0625) / 6));
    EXPECT_DOUBLE_EQ(d.relativeMse, (0.25 / 0.26 + 0.0625 / 0.01) / 6);
    EXPECT_DOUBLE_EQ(d.psnr(), 10 * std::log10(6 / 0.3125));
    EXPECT_EQ(d.max, 0.5);
    EXPECT_EQ(d.x, 0);
    EXPECT_EQ(d.y, 0);
    EXPECT_EQ(d.channel, 1);
}

TEST(Differences, TheReferenceIsTheSecond) {
    const Image bright{1, 1, {glm::vec3(1.0f)}}, dark{1, 1, {glm::vec3(0.0f)}};
    EXPECT_DOUBLE_EQ(differencesOf(bright, dark).relativeMse, 1 / 0.01);
    EXPECT_DOUBLE_EQ(differencesOf(dark, bright).relativeMse, 1 / 1.01);
}

TEST(Differences, ThePeakIsTheLargestValueButOneAtLeast) {
    const Image a{1, 1, {glm::vec3(2.0f)}}, b{1, 1, {glm::vec3(10.0f)}};
    EXPECT_EQ(differencesOf(a, b).peak, 10.0);
    EXPECT_DOUBLE_EQ(differencesOf(a, b).psnr(), 20 * std::log10(10.0 / 8.0));
    EXPECT_EQ(differencesOf(Image{1, 1, {glm::vec3(0.1f)}}, Image{1, 1, {glm::vec3(0.2f)}}).peak,
              1.0);
}

TEST(Differences, EqualImagesHaveNone) {
    const Image a{1, 2, {{0.1f, 3e38f, -1.0f}, {0.0f, 1e-40f, 7.0f}}};
    const Differences d = differencesOf(a, a);
    EXPECT_EQ(d.rmse, 0.0);
    EXPECT_EQ(d.relativeMse, 0.0);
    EXPECT_EQ(d.max, 0.0);
    EXPECT_EQ(d.psnr(), std::numeric_limits<double>::infinity());
}

TEST(Differences, OfTheLargestFloatsAreFinite) {
    const Image a{1, 1, {glm::vec3(3e38f)}}, b{1, 1, {glm::vec3(-3e38f)}};
    const Differences d = differencesOf(a, b);
    EXPECT_DOUBLE_EQ(d.max, 2 * (double) 3e38f);
    EXPECT_DOUBLE_EQ(d.rmse, d.max);
}

TEST(Differences, PixelsThatAreNotFiniteAreLeftOut) {
    const Image a{4, 1, {{kNan, 0, 0}, {1, 1, 1}, {0, kInfinity, 0}, {2, 2, 2}}};
    const Image b{4, 1, {{0, 0, 0}, {0, 0, -kInfinity}, {0, kInfinity, 0}, {3, 2, 2}}};
    EXPECT_EQ(countNonFinite(a), 2u);
    EXPECT_EQ(countNonFinite(b), 2u);
    const Differences d = differencesOf(a, b);
    EXPECT_EQ(d.pixels, 1u);
    EXPECT_DOUBLE_EQ(d.rmse, std::sqrt(1.0 / 3.0));
    EXPECT_EQ(d.x, 3);
}

TEST(ColourMap, LightnessGrowsEvenly) {
    const auto lightness = [](double value) {
        const glm::u8vec3 colour = falseColour(value);
        return linearToLab({decodeSrgb(colour.r / 255.0), decodeSrgb(colour.g / 255.0),
                            decodeSrgb(colour.b / 255.0)})
            .x;
    };
    EXPECT_EQ(falseColour(0.0), glm::u8vec3(0, 0, 0));
    EXPECT_EQ(falseColour(-1.0), falseColour(0.0));
    EXPECT_EQ(falseColour(2.0), falseColour(1.0));
    for (int i = 1; i <= 64; ++i) EXPECT_GT(lightness(i / 64.0), lightness((i - 1) / 64.0)) << i;
    // Clipping to the gamut and interpolating in sRGB move lightness by a few of its hundred steps.
    for (int i = 0; i <= 64; ++i) EXPECT_NEAR(lightness(i / 64.0), 98.0 * i / 64.0, 6.0) << i;
}

} // namespace
} // namespace dirt::test
