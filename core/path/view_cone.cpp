#include "core/path/view_cone.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <numbers>

namespace dirt {

namespace {

/// Where distance + t * change, a distance from one side of the cone, becomes negative.
float crossing(float distance, float change) {
    if (!(change < 0.0f)) return FLT_MAX;
    return std::min(std::max(distance, 0.0f) / -change, FLT_MAX);
}

} // namespace

ViewCone::ViewCone(const Camera& camera, int width, int height) {
    const double slopeY = std::tan(camera.verticalFov * (std::numbers::pi / 360.0));
    slopeX_ = (float) (slopeY * width / height);
    slopeY_ = (float) slopeY;
}

float ViewCone::exit(const Ray& ray) const {
    const glm::vec3 o = ray.origin, d = ray.direction;
    const float x = std::min(crossing(slopeX_ * o.z - o.x, slopeX_ * d.z - d.x),
                             crossing(slopeX_ * o.z + o.x, slopeX_ * d.z + d.x));
    const float y = std::min(crossing(slopeY_ * o.z - o.y, slopeY_ * d.z - d.y),
                             crossing(slopeY_ * o.z + o.y, slopeY_ * d.z + d.y));
    return std::min(x, y);
}

} // namespace dirt
