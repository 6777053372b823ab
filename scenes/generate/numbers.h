#pragma once

#include <algorithm>
#include <numbers>

namespace dirt::generate {

constexpr double pi = std::numbers::pi;
constexpr double turn = 2 * pi;

/// 0 up to \p low, 1 from \p high on, and smoothly from one to the other.
inline double smoothStep(double low, double high, double x) {
    const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

} // namespace dirt::generate
