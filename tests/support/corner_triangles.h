#pragma once

#include "tests/support/views.h"

#include <cmath>

namespace dirt::test {

/// A triangle whose edge ab has its middle exactly on the corner ray of a guard-banded tile: no sum
/// of rounded products tells on which side. Half of them are needles, a few ulp wide, of which the
/// same is true of all three edges.
struct CornerTriangle {
    int column, row;
    Triangle triangle;
};

inline CornerTriangle throughCorner(Random& random, const View& view) {
    const int column = random.below(view.columns), row = random.below(view.rows);
    const bool left = random.chance(0.5), above = random.chance(0.5);
    const glm::vec3 corner(left ? view.sLo[(size_t) column] : view.sHi[(size_t) column],
                           above ? view.tLo[(size_t) row] : view.tHi[(size_t) row], 1.0f);
    glm::vec3 a, b, c(0.0f);
    const bool needle = random.chance(0.5);
    const int part = random.range(-3, 3);
    for (int i = 0; i < 3; ++i) { // multiples of an ulp: both sums are exact
        const float ulp = std::nextafter(std::abs(corner[i]), 4.0f) - std::abs(corner[i]);
        const int steps = 4 * random.range(-200'000, 200'000);
        a[i] = corner[i] + ulp * (float) steps;
        b[i] = corner[i] - ulp * (float) steps;
        c[i] = corner[i] + ulp * (float) (steps / 4 * part + random.range(-1, 1));
    }
    if (!needle)
        c = {(float) random.uniform(-1, 1), (float) random.uniform(-1, 1),
             (float) random.uniform(-1, 1)};
    const float scale = (float) random.powerOfTwo(-8, 0);
    return {column,
            row,
            {fromView(view, a * scale), fromView(view, b * scale), fromView(view, c * scale)}};
}

} // namespace dirt::test
