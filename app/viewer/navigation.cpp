#include "app/viewer/navigation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace dirt {

namespace {

/// The view of a camera: its axes in world space, of length 1.
struct Axes {
    glm::dvec3 ahead, right, up;

    explicit Axes(const Camera& camera)
        : ahead(glm::normalize(glm::dvec3(camera.target) - glm::dvec3(camera.eye))),
          up(glm::normalize(glm::dvec3(camera.up))) {
        right = glm::normalize(glm::cross(ahead, up));
    }
};

} // namespace

void moveCamera(Camera& camera, double ahead, double right, double up) {
    const Axes axes(camera);
    const glm::dvec3 eye =
        glm::dvec3(camera.eye) + axes.ahead * ahead + axes.right * right + axes.up * up;
    // Both by the step that float32 leaves of it, so that the direction stays.
    const glm::dvec3 step = glm::dvec3(glm::vec3(eye)) - glm::dvec3(camera.eye);
    camera.eye = glm::vec3(eye);
    camera.target = glm::vec3(glm::dvec3(camera.target) + step);
}

void turnCamera(Camera& camera, double right, double up) {
    constexpr double kSteepest = 0.49 * std::numbers::pi; // 88 degrees
    const Axes axes(camera);
    const glm::dvec3 level = glm::cross(axes.up, axes.right);
    const double pitch = std::asin(std::clamp(glm::dot(axes.ahead, axes.up), -1.0, 1.0));
    const double newPitch =
        std::clamp(pitch + up, std::min(pitch, -kSteepest), std::max(pitch, kSteepest));
    const glm::dvec3 heading = level * std::cos(right) + axes.right * std::sin(right);
    const glm::dvec3 ahead = heading * std::cos(newPitch) + axes.up * std::sin(newPitch);
    const double distance = glm::length(glm::dvec3(camera.target) - glm::dvec3(camera.eye));
    camera.target = glm::vec3(glm::dvec3(camera.eye) + ahead * distance);
}

} // namespace dirt
