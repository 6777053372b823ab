#pragma once

#include "tests/support/print.h"
#include "tests/support/random.h"

#include <array>
#include <cfloat>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>
#include <gtest/gtest.h>

/// How near a computation comes to the bound of its error: hill climbing over its inputs, held
/// against exact arithmetic.
namespace dirt::test {

inline constexpr double u = 0x1p-24, v = 0x1p-53; // a rounding to float, to double

/// The numbers of one case: vertices, origins, directions, one after the other.
template <size_t N>
using Numbers = std::array<float, N>;

template <size_t N>
glm::vec3 vectorAt(const Numbers<N>& x, size_t i) {
    return {x[3 * i], x[3 * i + 1], x[3 * i + 2]};
}

template <size_t N>
std::string hex(const Numbers<N>& x) {
    std::string text = "{";
    for (const float number : x) text += (text.size() > 1 ? ", " : "") + hex(number) + "f";
    return text + "}";
}

/// What a search looks at. The score of a case is the part of the bound that it uses: 1 is all of
/// it, a negative one is less than none, -INFINITY no case at all.
template <size_t N>
struct Bound {
    const char* name;
    double published;              ///< docs/numerics.md: the worst case that is known comes so near
    std::vector<Numbers<N>> worst; ///< what long searches found
    std::function<Numbers<N>(Random&)> start;
    std::function<double(const Numbers<N>&)> score;
};

/// Anything like \p x: other digits, another exponent, another sign.
inline float changed(Random& random, float x) {
    float y = x;
    switch (random.below(8)) {
    case 0:
        return -x;
    case 1:
        return x * (float) random.powerOfTwo(-2, 2);
    case 2: // other digits
        y = std::copysign(std::ldexp((float) random.uniform(1, 2), std::ilogb(x)), x);
        break;
    case 3: // next to a power of two, where a rounding is largest
        y = std::copysign(std::ldexp(1.0f, std::ilogb(x)), x);
        for (int steps = random.below(4); steps > 0; --steps) y = std::nextafter(y, 2.0f * y);
        break;
    case 4:
    case 5: // some of the last digits
        y = x * (float) (1.0 + random.sign() * std::exp2(random.uniform(-23, -1)));
        break;
    default:
        for (int steps = random.range(1, 3); steps > 0; --steps)
            y = std::nextafter(y, random.chance(0.5) ? 2.0f * x : 0.0f);
    }
    return std::isfinite(y) && std::abs(y) >= FLT_MIN ? y : x;
}

/// The highest place reached in \p steps steps from \p at on.
template <size_t N>
double climb(const Bound<N>& bound, Random& random, Numbers<N>& at, int steps) {
    double best = bound.score(at);
    for (int i = 0; i < steps; ++i) {
        Numbers<N> next = at;
        for (int changes = random.pick({1, 1, 2, 3}); changes > 0; --changes) {
            float& x = next[(size_t) random.below((int) N)];
            x = changed(random, x);
        }
        const double score = bound.score(next);
        if (score >= best) best = score, at = next;
    }
    return best;
}

/// No case is beyond the bound, and the worst that is known uses the published part of it. Prints
/// what was found.
template <size_t N>
void expectHeld(const Bound<N>& bound) {
    Random random(20161193);
    Numbers<N> worst{};
    double best = -INFINITY;
    const auto keep = [&](const Numbers<N>& at, double score) {
        if (score > best) best = score, worst = at;
    };
    for (const Numbers<N>& at : bound.worst) keep(at, bound.score(at));
    const double known = best;
    const int starts = cases(20, 500), steps = cases(2000, 10'000);
    for (int i = 0; i < starts; ++i) {
        Numbers<N> at = bound.start(random);
        const double score = climb(bound, random, at, steps);
        keep(at, score);
    }
    for (Numbers<N> at : bound.worst) {
        const double score = climb(bound, random, at, steps);
        keep(at, score);
    }
    std::printf("%-44s %.3f of the bound\n", bound.name, best);
    if (fullTests() && best > known) std::printf("  %s\n", hex(worst).c_str());
    EXPECT_LE(best, 1.0) << bound.name << ": " << hex(worst);
    EXPECT_GE(best, bound.published) << bound.name;
}

} // namespace dirt::test
