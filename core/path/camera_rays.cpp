#include "core/path/camera_rays.h"

#include <cmath>
#include <numbers>

namespace dirt {

CameraRays::CameraRays(const Camera& camera, int width, int height, ViewMode mode, float scale) {
    const double slopeY = std::tan(camera.verticalFov * (std::numbers::pi / 360.0));
    const double slopeX = slopeY * width / height;
    plane_.slopeX = (float) -slopeX;
    plane_.slopeY = (float) -slopeY;
    plane_.stepX = (float) (2.0 * slopeX / width);
    plane_.stepY = (float) (2.0 * slopeY / height);
    plane_.lensRadius = camera.apertureRadius * scale;
    plane_.focalDistance = camera.focalDistance * scale;
    if (mode == ViewMode::single) {
        plane_.right = {1, 0, 0};
        plane_.down = {0, 1, 0};
        plane_.forward = {0, 0, 1};
    } else {
        const CameraBasis basis = cameraBasis(camera);
        plane_.right = basis.right;
        plane_.down = basis.down;
        plane_.forward = basis.forward;
    }
}

Ray CameraRays::through(float x, float y) const {
    Ray ray;
    ray.direction = cameraDirection(plane_, x, y);
    return ray;
}

Ray CameraRays::through(float x, float y, float u, float v) const {
    Ray ray;
    lensRay(plane_, cameraDirection(plane_, x, y), u, v, ray.origin, ray.direction);
    return ray;
}

} // namespace dirt
