#include "core/scene/transform.h"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

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

glm::dmat3 rotationMatrix(const Rotation& rotation) {
    const auto [s, c] = sineCosine(rotation.degrees);
    const glm::dvec3 n = glm::normalize(rotation.axis);
    // Rodrigues: the columns are the images of the unit vectors.
    glm::dmat3 m(1.0);
    for (int i = 0; i < 3; ++i) {
        glm::dvec3 unit(0.0);
        unit[i] = 1.0;
        m[i] = unit * c + glm::cross(n, unit) * s + n * (n[i] * (1.0 - c));
    }
    return m;
}

glm::dmat4 placement(const glm::dvec3& scale, const glm::dmat3& rotation,
                     const glm::dvec3& translation) {
    glm::dmat4 m(1.0);
    for (int i = 0; i < 3; ++i) m[i] = glm::dvec4(rotation[i] * scale[i], 0.0);
    m[3] = glm::dvec4(translation, 1.0);
    return m;
}

/// The cofactor matrix, turned where the transform mirrors.
glm::dmat3 normalMatrix(const glm::dmat3& m) {
    const glm::dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]),
                               glm::cross(m[0], m[1]));
    return glm::dot(m[0], cofactors[0]) < 0.0 ? -cofactors : cofactors;
}

} // namespace dirt
