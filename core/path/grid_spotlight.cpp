#include "core/path/grid_spotlight.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace dirt {

namespace {

/// 1 - cos(fullAngle / 2), without the cancellation that narrow cones would suffer.
double versine(float fullAngleDegrees) {
    const double s = std::sin(fullAngleDegrees * (std::numbers::pi / 720.0));
    return 2.0 * s * s;
}

/// The power of two that brings the largest coordinate of a far light into [1, 2); 1 of one that is
/// no farther than the scene.
float unitOf(glm::vec3 position) {
    const float largest =
        std::max({std::abs(position.x), std::abs(position.y), std::abs(position.z), 1.0f});
    return std::isfinite(largest) ? std::exp2((float) std::ilogb(largest)) : 1.0f;
}

} // namespace

GridSpotlight makeGridSpotlight(const Spotlight& light, const GridFrame& frame) {
    GridSpotlight result;
    result.position = frame.toGrid(light.position);
    result.exponent = light.exponent;
    result.conical = light.conical ? 1 : 0;

    // World axes of the light, world Y up as far as that goes; then into the grid frame.
    const glm::dvec3 axis = glm::normalize(glm::dvec3(light.target) - glm::dvec3(light.position));
    const glm::dvec3 upward = std::abs(axis.y) < 0.999 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1);
    const glm::dvec3 right = glm::normalize(glm::cross(axis, upward));
    const glm::dvec3 up = glm::cross(right, axis);
    result.axis = frame.directionToGrid(glm::vec3(axis));
    result.right = frame.directionToGrid(glm::vec3(right));
    result.up = frame.directionToGrid(glm::vec3(up));

    const double outer = versine(light.aperture);
    const double inner = versine(std::min(light.penumbra, light.aperture));
    result.outer = (float) outer;
    result.range = (float) (outer - inner);

    result.unit = unitOf(result.position);
    const double scale = (double) frame.scale / result.unit;
    const double solidAngle = 2.0 * std::numbers::pi * outer;
    const double white = std::min(light.flux / solidAngle * scale * scale, DBL_MAX);
    const glm::dvec3 intensity = glm::dvec3(light.color) * white;
    result.intensity = glm::vec3(glm::min(intensity, (double) FLT_MAX));
    return result;
}

} // namespace dirt
