#include "shaders/shared/error_function.h"
#include "shaders/shared/trigonometry.h"

#include <algorithm>
#include <bit>
#include <cfloat>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include <gtest/gtest.h>

namespace dirt {
namespace {

/// Distance from the exact value, in units of its last place as a float.
double ulps(float value, double exact) {
    if (exact == 0.0) return value == 0.0f ? 0.0 : HUGE_VAL;
    const int exponent = std::max(std::ilogb(exact), -126);
    return std::abs(value - exact) / std::ldexp(1.0, exponent - 23);
}

TEST(Polynomials, SineAndCosineOfEveryRandomNumber) {
    double worstSine = 0.0, worstCosine = 0.0;
    for (int i = 0; i <= 1 << 24; ++i) {
        const float u = (float) i * 0x1p-24f;
        float sine, cosine;
        sinCosTwoPi(u, sine, cosine);
        // Reduced as exactly as the function does, or libm's 2 pi u would be the one in error.
        const double quarters = 4.0 * u, nearest = std::floor(quarters + 0.5);
        const double angle = (quarters - nearest) * (std::numbers::pi / 2.0);
        const double s = std::sin(angle), c = std::cos(angle);
        const double exactSine[] = {s, c, -s, -c}, exactCosine[] = {c, -s, -c, s};
        const int quadrant = (int) nearest & 3;
        worstSine = std::max(worstSine, ulps(sine, exactSine[quadrant]));
        worstCosine = std::max(worstCosine, ulps(cosine, exactCosine[quadrant]));
    }
    RecordProperty("sine", std::to_string(worstSine));
    RecordProperty("cosine", std::to_string(worstCosine));
    EXPECT_LE(worstSine, 1.7);
    EXPECT_LE(worstCosine, 1.7);
}

TEST(Polynomials, QuarterTurnsAreExact) {
    const float sines[] = {0, 1, 0, -1, 0}, cosines[] = {1, 0, -1, 0, 1};
    for (int i = 0; i <= 4; ++i) {
        float sine, cosine;
        sinCosTwoPi((float) i / 4.0f, sine, cosine);
        EXPECT_EQ(sine, sines[i]) << i;
        EXPECT_EQ(cosine, cosines[i]) << i;
    }
}

TEST(Polynomials, Logarithm) {
    // Everything within two octaves of 1, where the tone curve lives, and a sieve of the rest; all
    // normal floats in the long form.
    const uint32_t first = std::bit_cast<uint32_t>(FLT_MIN),
                   last = std::bit_cast<uint32_t>(FLT_MAX);
    const uint32_t low = std::bit_cast<uint32_t>(0.25f), high = std::bit_cast<uint32_t>(4.0f);
    const uint32_t stride = std::getenv("DIRT_TEST_FULL") ? 1 : 997;
    double worst = 0.0;
    for (uint32_t bits = first; bits <= last; bits += bits >= low && bits < high ? 1 : stride) {
        const float x = std::bit_cast<float>(bits);
        worst = std::max(worst, ulps(naturalLog(x), std::log((double) x)));
    }
    RecordProperty("log", std::to_string(worst));
    EXPECT_LE(worst, 0.9);
    EXPECT_EQ(naturalLog(1.0f), 0.0f);
}

TEST(Polynomials, PowerOfTwo) {
    double worst = 0.0;
    for (int i = -125 * 65536; i <= 127 * 65536; ++i) {
        const float x = (float) i / 65536.0f;
        worst = std::max(worst, ulps(powerOfTwo(x), std::exp2((double) x)));
    }
    RecordProperty("exp2", std::to_string(worst));
    EXPECT_LE(worst, 1.2);
    EXPECT_EQ(powerOfTwo(-1000.0f), 0.0f);
    EXPECT_EQ(powerOfTwo(1000.0f), FLT_MAX);
    for (int e = -125; e <= 127; ++e) EXPECT_EQ(powerOfTwo((float) e), std::ldexp(1.0f, e));
}

TEST(Polynomials, PowerOfUnitNumbers) {
    for (int i = 1; i <= 4096; ++i)
        for (float y : {0.0f, 0.5f, 1.0f, 2.0f, 8.0f, 20.0f}) {
            const float x = (float) i / 4096.0f;
            const double exact = std::pow((double) x, (double) y);
            if (exact < 0x1p-124) continue;
            const double bound = 0x1p-22 * (1.0 - y * std::log2((double) x));
            ASSERT_NEAR(unitPower(x, y) / exact, 1.0, bound) << x << "^" << y;
        }
}

TEST(Polynomials, ExponentialNearZeroAndFar) {
    for (float x = 0x1p-40f; x < 16.0f; x *= 1.01f) {
        EXPECT_NEAR(exponential(-x) / std::exp(-(double) x), 1.0, 0x1p-22 * (1.0 + x)) << x;
        EXPECT_NEAR(exponentialMinusOne(x) / std::expm1((double) x), 1.0, 0x1p-21 * (1.0 + x)) << x;
        EXPECT_NEAR(logOnePlus(x) / std::log1p((double) x), 1.0, 0x1p-22) << x;
    }
    EXPECT_EQ(exponentialMinusOne(0.0f), 0.0f);
    EXPECT_EQ(logOnePlus(0.0f), 0.0f);
}

TEST(Polynomials, ErrorFunction) {
    for (float x = 0x1p-20f; x < 5.0f; x *= 1.003f) {
        const double exact = std::erfc((double) x), gaussian = std::exp(-(double) x * x);
        EXPECT_NEAR(scaledErrorComplement(x) / (exact / gaussian), 1.0, 6e-7) << x;
        EXPECT_NEAR(errorComplement(-x, (float) gaussian) / (2.0 - exact), 1.0, 6e-7) << x;
    }
}

} // namespace
} // namespace dirt
