#include "core/scene/texture.h"

#include <gtest/gtest.h>

#include <cfloat>
#include <cmath>
#include <vector>

namespace dirt {
namespace {

/// 2 x 2, red grows to the right, green downwards.
Texture quadrants() {
    return Texture("q", 2, 2, std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0});
}

TEST(Texture, HitsTexelCentres) {
    const Texture texture = quadrants();
    EXPECT_EQ(texture.sample({0.25f, 0.75f}), glm::vec3(0, 0, 0)); // top left: v runs upwards
    EXPECT_EQ(texture.sample({0.75f, 0.75f}), glm::vec3(1, 0, 0));
    EXPECT_EQ(texture.sample({0.25f, 0.25f}), glm::vec3(0, 1, 0));
    EXPECT_EQ(texture.sample({0.75f, 0.25f}), glm::vec3(1, 1, 0));
}

TEST(Texture, InterpolatesBetweenCentresAndAcrossTheBorder) {
    const Texture texture = quadrants();
    EXPECT_EQ(texture.sample({0.5f, 0.5f}), glm::vec3(0.5f, 0.5f, 0));
    EXPECT_EQ(texture.sample({0.375f, 0.75f}), glm::vec3(0.25f, 0, 0));
    EXPECT_EQ(texture.sample({0.0f, 0.75f}), glm::vec3(0.5f, 0, 0)); // half of the last column
    EXPECT_EQ(texture.sample({0.25f, 1.0f}), glm::vec3(0, 0.5f, 0)); // half of the last row
}

TEST(Texture, Repeats) {
    const Texture texture = quadrants();
    // Dyadic coordinates: adding a period is exact.
    for (const glm::vec2 uv : {glm::vec2(0.125f, 0.875f), glm::vec2(0.5f, 0.0625f)})
        for (const float period : {-1.0f, 1.0f, -1000.0f, 65536.0f})
            EXPECT_EQ(texture.sample(uv + period), texture.sample(uv)) << period;
}

TEST(Texture, TakesAnyFiniteCoordinates) {
    const float values[] = {0.0f,   -0.0f, 1.0f,  -1.0f,      FLT_MIN, -FLT_MIN, 1e-45f,  -1e-45f,
                            -1e-8f, 1e9f,  -1e9f, 8388607.5f, 3e30f,   -3e30f,   FLT_MAX, -FLT_MAX};
    const Texture one("one", 1, 1, std::vector<float>{0.25f, 0.5f, 1.0f});
    const Texture wide("wide", 3, 1, std::vector<float>(9, 0.5f));
    for (const float u : values)
        for (const float v : values) {
            EXPECT_EQ(one.sample({u, v}), glm::vec3(0.25f, 0.5f, 1.0f)) << u << ' ' << v;
            const glm::vec3 mixed = quadrants().sample({u, v});
            EXPECT_TRUE(mixed.x >= 0 && mixed.x <= 1 && mixed.y >= 0 && mixed.y <= 1)
                << u << ' ' << v;
            // (1 - w) / 2 + w / 2, twice: each sum is rounded once, at most half an ulp below 1/2.
            EXPECT_NEAR(wide.sample({u, v}).x, 0.5f, FLT_EPSILON / 2) << u << ' ' << v;
        }
}

TEST(Texture, DecodesSrgb) {
    // The curve in long double, rounded once: at most the last bit can differ.
    for (int i = 0; i < 256; ++i) {
        const Texture texture("t", 1, 1, std::vector<uint8_t>(3, (uint8_t) i));
        const long double s = i / 255.0L;
        const long double linear =
            s <= 0.04045L ? s / 12.92L : std::pow((s + 0.055L) / 1.055L, 2.4L);
        const float expected = (float) linear;
        const float value = texture.sample({0.5f, 0.5f}).x;
        EXPECT_LE(std::fabs(value - expected), std::nextafter(expected, 2.0f) - expected) << i;
    }
    EXPECT_EQ(Texture("t", 1, 1, std::vector<uint8_t>(3, 0)).sample({0, 0}).x, 0.0f);
    EXPECT_EQ(Texture("t", 1, 1, std::vector<uint8_t>(3, 255)).sample({0, 0}).x, 1.0f);
}

TEST(Texture, InterpolatesLinearValuesNotEncodedOnes) {
    const Texture texture("t", 2, 1, std::vector<uint8_t>{0, 0, 0, 255, 255, 255});
    EXPECT_EQ(texture.sample({0.5f, 0.5f}), glm::vec3(0.5f));
}

TEST(Texture, KnowsItsSize) {
    EXPECT_EQ(Texture("t", 2, 3, std::vector<uint8_t>(18)).bytes(), 18u);
    EXPECT_EQ(Texture("t", 2, 3, std::vector<float>(18)).bytes(), 72u);
    EXPECT_EQ(quadrants().width(), 2);
    EXPECT_EQ(quadrants().file(), "q");
}

} // namespace
} // namespace dirt
