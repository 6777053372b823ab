#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace dirt {

/// Whether a triangle has an area where its corners are \p exact, and none where they are \p
/// rounded to float32.
inline bool losesArea(const std::array<glm::dvec3, 3>& exact,
                      const std::array<glm::vec3, 3>& rounded) {
    const glm::dvec3 a(rounded[0]), b(rounded[1]), c(rounded[2]);
    // Differences of float32 numbers are exact in double, but for ratios that show in no picture.
    if (glm::cross(b - a, c - a) != glm::dvec3(0.0)) return false;
    const glm::dvec3 u = exact[1] - exact[0], v = exact[2] - exact[0];
    const auto largest = [](const glm::dvec3& p) {
        return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    };
    // Coordinates come from decimal numbers by way of a matrix, with at most eight roundings to
    // half an ulp each; so wrong may each component of the edges be, and the products of two edges
    // by that times both.
    const double coordinate = std::max({largest(exact[0]), largest(exact[1]), largest(exact[2])});
    const double error = 8.0 * std::numeric_limits<double>::epsilon() * coordinate;
    return largest(glm::cross(u, v)) > 4.0 * error * (largest(u) + largest(v));
}

} // namespace dirt
