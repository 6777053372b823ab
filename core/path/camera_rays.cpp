#include "core/path/camera_rays.h"

#include "shaders/shared/random.h"

#include <cmath>
#include <numbers>

namespace dirt {

glm::vec2 subPixelOffset(uint32_t sample, uint32_t seed) {
    return {randomUnit(kAllPixels, sample, 0, kDimensionPixelX, seed),
            randomUnit(kAllPixels, sample, 0, kDimensionPixelY, seed)};
}

CameraRays::CameraRays(const Camera& camera, int width, int height, ViewMode mode) {
    const double slopeY = std::tan(camera.verticalFov * (std::numbers::pi / 360.0));
    const double slopeX = slopeY * width / height;
    slope_ = {(float) -slopeX, (float) -slopeY};
    step_ = {(float) (2.0 * slopeX / width), (float) (2.0 * slopeY / height)};
    if (mode == ViewMode::single) {
        right_ = {1, 0, 0};
        down_ = {0, 1, 0};
        forward_ = {0, 0, 1};
    } else {
        const CameraBasis basis = cameraBasis(camera);
        right_ = basis.right;
        down_ = basis.down;
        forward_ = basis.forward;
    }
}

Ray CameraRays::through(float x, float y) const {
    const float sx = slope_.x + x * step_.x;
    const float sy = slope_.y + y * step_.y;
    Ray ray;
    ray.direction = right_ * sx + down_ * sy + forward_;
    return ray;
}

} // namespace dirt
