#ifndef DIRT_SHARED_CAMERA_RAYS_H
#define DIRT_SHARED_CAMERA_RAYS_H

#include "shaders/shared/language.h"

DIRT_SHARED_BEGIN

/// The image plane at distance 1 from the eye, in the grid frame (std140).
struct ImagePlane {
    vec3 right DIRT_DEFAULT(0.0f);
    float slopeX DIRT_DEFAULT(0.0f); // at the left rim, in units of right
    vec3 down DIRT_DEFAULT(0.0f);
    float slopeY DIRT_DEFAULT(0.0f); // at the upper rim, in units of down
    vec3 forward DIRT_DEFAULT(0.0f);
    float stepX DIRT_DEFAULT(0.0f); // slope of one pixel
    float stepY DIRT_DEFAULT(0.0f);
    float unused0 DIRT_DEFAULT(0.0f);
    float unused1 DIRT_DEFAULT(0.0f);
    float unused2 DIRT_DEFAULT(0.0f);
};

/// Direction from the eye to the point (\p x, \p y) of the image, in pixels; not of unit length.
DIRT_FUNCTION vec3 cameraDirection(ImagePlane plane, float x, float y) {
    DIRT_PRECISE float sx = plane.slopeX + x * plane.stepX;
    DIRT_PRECISE float sy = plane.slopeY + y * plane.stepY;
    DIRT_PRECISE vec3 direction = plane.right * sx + plane.down * sy + plane.forward;
    return direction;
}

DIRT_SHARED_END

#ifdef __cplusplus

#include <cstddef>

namespace dirt {
static_assert(sizeof(ImagePlane) == 64 && offsetof(ImagePlane, down) == 16 &&
              offsetof(ImagePlane, forward) == 32 && offsetof(ImagePlane, stepY) == 48);
} // namespace dirt

#endif

#endif
