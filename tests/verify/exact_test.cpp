#include "core/verify/exact.h"
#include "tests/verify/rational_oracle.h"

#include <cfloat>
#include <random>

#include <gtest/gtest.h>

using namespace dirt;
using test::Rational;

namespace {

/// Floats over 80 binary orders of magnitude, and zeros.
float wideFloat(std::mt19937& random) {
    if (random() % 8 == 0) return 0.0f;
    const float mantissa = std::uniform_real_distribution<float>(-1.0f, 1.0f)(random);
    return std::ldexp(mantissa, (int) (random() % 80) - 40);
}

int signOf(const Rational& r) {
    return r.sign();
}

} // namespace

TEST(Dyadic, SumsAndProductsEqualRationals) {
    std::mt19937 random(1);
    for (int i = 0; i < 20000; i++) {
        const float a = wideFloat(random), b = wideFloat(random), c = wideFloat(random);
        const Rational ra(a), rb(b), rc(c);
        const Dyadic value = Dyadic(a) * Dyadic(b) - Dyadic(c) * Dyadic(c) + Dyadic(b);
        const Rational expected = ra * rb - rc * rc + rb;
        ASSERT_EQ(value.sign(), signOf(expected));
        if (expected == 0) continue;
        const double quotient = Dyadic::quotient(value, Dyadic(3.0));
        const Rational error = abs(Rational(quotient) * 3 / expected - 1);
        ASSERT_LT(error, Rational(0x1p-50)) << a << " " << b << " " << c;
    }
}

TEST(Dyadic, HoldsTheExtremesOfFloat) {
    const Dyadic tiny(FLT_TRUE_MIN), huge(FLT_MAX);
    EXPECT_EQ((huge + tiny - huge - tiny).sign(), 0);
    EXPECT_EQ((huge + tiny - huge).sign(), 1);
    EXPECT_EQ(Dyadic::quotient(tiny * huge, huge), (double) FLT_TRUE_MIN);
}

TEST(ExactT, RelativeErrorIsExactToDouble) {
    const ExactT third{Dyadic(1.0), Dyadic(3.0)};
    const double expected = std::abs((double) (1.0f / 3.0f) * 3.0 - 1.0);
    EXPECT_EQ(relativeError(1.0f / 3.0f, third), expected);
    EXPECT_EQ(relativeError(0.25f, {Dyadic(1.0), Dyadic(4.0)}), 0.0);
    EXPECT_EQ(relativeError(0.0f, third), 1.0);
    EXPECT_EQ(relativeError(0.0f, {Dyadic(FLT_MIN), Dyadic(2.0)}), 0.0) << "flushed to zero";
    EXPECT_TRUE(std::isinf(relativeError(NAN, third)));
}

TEST(ExactT, ExceedsIsStrict) {
    const ExactT one{Dyadic(1.0), Dyadic(1.0)};
    const auto below = [](double amount) { return ExactT{Dyadic(1.0 - amount), Dyadic(1.0)}; };
    EXPECT_FALSE(exceeds(one, one, 0x1p-23f));
    EXPECT_FALSE(exceeds(one, below(0x1p-23), 0x1p-23f));
    EXPECT_TRUE(exceeds(one, below(0x1p-23 + 0x1p-50), 0x1p-23f));
}

TEST(IntersectExactly, SideOfBorderIsExact) {
    // x = s w exactly at t = 2, and one step of float beside it.
    Ray ray{{1.0f, 0.0f, 1.0f}, {1.0f, 0.0f, 1.0f}, kNoPrimitive};
    const ExactT two{Dyadic(2.0), Dyadic(1.0)};
    EXPECT_EQ(sideOfBorder(ray, two, 0, 1.0f, 2, 1.0f), 0);
    ray.origin.x = std::nextafter(1.0f, 2.0f);
    EXPECT_EQ(sideOfBorder(ray, two, 0, 1.0f, 2, 1.0f), 1);
    EXPECT_EQ(sideOfBorder(ray, two, 0, -1.0f, 2, -1.0f), 1);
}
