#pragma once

#include "core/grid/geometry.h"
#include "core/trace/ray.h"
#include "shaders/shared/image_plane.h"

#include <cstdint>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace dirt {

/// Rays through the pixels of an image, from the eye, in the grid frame. Pixel (0, 0) is top left,
/// its centre (0.5, 0.5). In single mode the direction is (x, y, 1), x and y the pixel's slopes; in
/// full mode it is the same direction on world axes, not of unit length.
class CameraRays {
public:
    /// \p scale: the grid frame's, which the lens needs.
    CameraRays(const Camera& camera, int width, int height, ViewMode mode, float scale = 1.0f);

    /// Ray through the point (\p x, \p y) of the image plane, in pixels.
    Ray through(float x, float y) const;
    /// The same through the point of the lens that \p u and \p v of [0, 1) choose.
    Ray through(float x, float y, float u, float v) const;

    const ImagePlane& plane() const { return plane_; }

private:
    ImagePlane plane_;
};

} // namespace dirt
