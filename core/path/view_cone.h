#pragma once

#include "core/scene/camera.h"
#include "core/trace/ray.h"

namespace dirt {

/// The cone of the camera's view in the grid frame of single mode, |x| <= slopeX w and
/// |y| <= slopeY w. A ray that leaves it ends there: decided here, once, since structures that
/// hold geometry beyond the view would otherwise find more than the grid of one view can.
class ViewCone {
public:
    ViewCone(const Camera& camera, int width, int height);

    /// Where \p ray, which starts inside, leaves the cone: t in units of its direction, FLT_MAX if
    /// it stays inside for ever. The cone is convex, so that what lies before was not left.
    float exit(const Ray& ray) const;

private:
    float slopeX_, slopeY_;
};

} // namespace dirt
