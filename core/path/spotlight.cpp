#include "core/path/spotlight.h"

#include "shaders/shared/exponential.h"
#include "shaders/shared/sampling.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace dirt {

namespace {

/// 1 - cos(fullAngle / 2), without the cancellation that narrow cones would suffer.
double versine(float fullAngleDegrees) {
    const double s = std::sin(fullAngleDegrees * (std::numbers::pi / 720.0));
    return 2.0 * s * s;
}

} // namespace

GridSpotlight::GridSpotlight(const Spotlight& light, const GridFrame& frame)
    : exponent_(light.exponent), conical_(light.conical) {
    position_ = frame.toGrid(light.position);

    // World axes of the light, world Y up as far as that goes; then into the grid frame.
    const glm::dvec3 axis = glm::normalize(glm::dvec3(light.target) - glm::dvec3(light.position));
    const glm::dvec3 upward = std::abs(axis.y) < 0.999 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1);
    const glm::dvec3 right = glm::normalize(glm::cross(axis, upward));
    const glm::dvec3 up = glm::cross(right, axis);
    axis_ = frame.directionToGrid(glm::vec3(axis));
    right_ = frame.directionToGrid(glm::vec3(right));
    up_ = frame.directionToGrid(glm::vec3(up));

    const double outer = versine(light.aperture);
    const double inner = versine(std::min(light.penumbra, light.aperture));
    outer_ = (float) outer;
    range_ = (float) (outer - inner);

    const double scale = frame.scale;
    const double solidAngle = 2.0 * std::numbers::pi * outer;
    intensity_ = glm::vec3(glm::dvec3(light.color) * (light.flux / solidAngle * scale * scale));
}

float GridSpotlight::falloff(glm::vec3 fromLight) const {
    const float x = dotProduct(fromLight, right_);
    const float y = dotProduct(fromLight, up_);
    const float z = dotProduct(fromLight, axis_);
    // Squared distance from the axis; for the square frustum that of the larger coordinate, so
    // that the angle is taken to the frustum's nearest side.
    const float side = conical_ ? x * x + y * y : std::max(x * x, y * y);
    if (!conical_ && !(z > 0.0f)) return 0.0f;
    const float length = sqrt(side + z * z);
    // 1 - cos = sin^2 / (1 + cos), free of cancellation in front of the light.
    const float angle = z > 0.0f ? side / (length * (length + z)) : 1.0f - z / length;
    if (!(angle < outer_)) return 0.0f;
    if (!(outer_ - angle < range_)) return 1.0f;
    const float part = (outer_ - angle) / range_;
    return exponent_ == 1.0f ? part : unitPower(part, exponent_);
}

LightSample GridSpotlight::sample(glm::vec3 point) const {
    LightSample result{position_ - point, glm::vec3(0.0f), glm::vec3(0.0f)};
    const float squared = dotProduct(result.toLight, result.toLight);
    if (!(squared > 0.0f)) return result;
    result.direction = result.toLight * (1.0f / sqrt(squared));
    result.irradiance = intensity_ * (falloff(-result.toLight) / squared);
    return result;
}

} // namespace dirt
