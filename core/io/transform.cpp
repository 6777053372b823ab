#include "core/io/transform.h"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

namespace dirt {

namespace {

struct SineCosine {
    double sine, cosine;
};

SineCosine sineCosine(double degrees) {
    const double turn = std::fmod(degrees, 360.0);
    const double quarters = turn / 90.0;
    if (quarters != std::floor(quarters)) {
        const double radians = turn * (std::numbers::pi / 180.0);
        return {std::sin(radians), std::cos(radians)};
    }
    switch (((int) quarters + 4) % 4) {
    case 0:
        return {0.0, 1.0};
    case 1:
        return {1.0, 0.0};
    case 2:
        return {0.0, -1.0};
    default:
        return {-1.0, 0.0};
    }
}

} // namespace

glm::dmat4 placement(const glm::dvec3& scale, double degrees, const glm::dvec3& axis,
                     const glm::dvec3& translation) {
    const auto [s, c] = sineCosine(degrees);
    const glm::dvec3 n = glm::normalize(axis);
    // Rodrigues: the columns are the images of the unit vectors.
    glm::dmat4 m(1.0);
    for (int i = 0; i < 3; ++i) {
        glm::dvec3 unit(0.0);
        unit[i] = 1.0;
        const glm::dvec3 image = unit * c + glm::cross(n, unit) * s + n * (n[i] * (1.0 - c));
        m[i] = glm::dvec4(image * scale[i], 0.0);
    }
    m[3] = glm::dvec4(translation, 1.0);
    return m;
}

} // namespace dirt
