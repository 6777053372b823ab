#include "core/trace/determinant.h"
#include "core/verify/exact_number.h"
#include "tests/support/print.h"
#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <cfloat>

// The exact determinants: sign, zero, and a relative error of at most 2^-50.

namespace dirt::test {
namespace {

struct Inputs {
    glm::vec3 v[4];
};

glm::vec3 wide(Random& random, double lo, double hi) {
    return {(float) random.wide(lo, hi), (float) random.wide(lo, hi), (float) random.wide(lo, hi)};
}

/// Anything; nearly dependent vectors; small integers, whose determinants often vanish.
Inputs nasty(Random& random) {
    Inputs in;
    const int kind = random.below(6);
    for (glm::vec3& v : in.v) {
        if (kind == 0) v = wide(random, -6, 6);
        if (kind == 1) v = wide(random, -20, 20);
        if (kind == 2) v = wide(random, -30, 0);
        if (kind >= 3) v = wide(random, -1, 0);
        if (kind == 5)
            for (int i = 0; i < 3; ++i) v[i] = (float) random.range(-5, 5);
    }
    if (kind == 3) in.v[3] = (in.v[0] + in.v[1] + in.v[2]) * 0.333f;
    if (kind == 4) in.v[3] = in.v[2] + (in.v[1] - in.v[0]) * (float) random.powerOfTwo(-3, 3);
    if (random.chance(0.1)) in.v[random.below(4)] = glm::vec3(0.0f);
    if (random.chance(0.2)) in.v[random.below(4)] = in.v[random.below(4)];
    if (random.chance(0.1))
        for (glm::vec3& v : in.v) v.z = 0.0f;
    return in;
}

/// |f - exact| <= 2^-50 |exact| for exact = value * 2^exponent.
void expectExact(double f, const Integer& value, int exponent, const Inputs& in, const char* what) {
    const std::string where = std::string(what) + " " + hex(in.v[0]) + ", " + hex(in.v[1]) + ", " +
                              hex(in.v[2]) + ", " + hex(in.v[3]);
    ASSERT_EQ((f > 0) - (f < 0), sign(value)) << where;
    if (f == 0) return;
    const int unit = std::min(lowestExponent(f), exponent);
    const Integer scaled = value << (exponent - unit);
    ASSERT_LE(abs(toInteger(f, unit) - scaled) << 50, abs(scaled)) << where;
}

TEST(Determinant, ExactSignAndNearestValue) {
    Random random(7);
    for (int i = 0; i < cases(100'000, 1'000'000) && !HasFatalFailure(); ++i) {
        const Inputs in = nasty(random);
        int unit = 0;
        for (const glm::vec3& v : in.v) unit = std::min(unit, lowestExponent(v));
        IntegerVector v[4];
        for (int k = 0; k < 4; ++k) v[k] = toIntegers(in.v[k], unit);
        expectExact(edgeDeterminantExact(in.v[0], in.v[1], in.v[2], in.v[3]),
                    dot(v[1], cross(v[2] - v[0], v[3] - v[0])), 3 * unit, in, "edge");
        expectExact(planeDeterminantExact(in.v[0], in.v[1], in.v[2], in.v[3]),
                    dot(v[0] - v[1], cross(v[2] - v[1], v[3] - v[1])), 3 * unit, in, "plane");
        expectExact(directionDeterminantExact(in.v[0], in.v[1], in.v[2], in.v[3]),
                    dot(v[0], cross(v[2] - v[1], v[3] - v[1])), 3 * unit, in, "direction");
    }
}

TEST(Determinant, ReachesTheEndsOfFloat) {
    const float big = FLT_MAX, tiny = FLT_MIN;
    EXPECT_GT(edgeDeterminantExact({0, 0, 0}, {big, 0, 0}, {0, big, 0}, {0, 0, big}), 1e114);
    const double product =
        edgeDeterminantExact({0, 0, 0}, {tiny, 0, 0}, {0, tiny, 0}, {0, 0, tiny});
    EXPECT_EQ(product, (double) tiny * tiny * tiny);
    // The difference of neighbours, beside large terms that cancel.
    const float next = std::nextafter(1.0f, 2.0f);
    EXPECT_EQ(planeDeterminantExact({1, 1, next}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}), 0x1p-23);
    EXPECT_EQ(planeDeterminantExact({1, 1, 1}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}), 0.0);
}

} // namespace
} // namespace dirt::test
