#ifndef DIRT_SHARED_IMAGE_PLANE_H
#define DIRT_SHARED_IMAGE_PLANE_H

#include "shaders/shared/trigonometry.h"

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
    float lensRadius DIRT_DEFAULT(0.0f);    // in the grid frame's unit; 0: a pinhole
    float focalDistance DIRT_DEFAULT(0.0f); // likewise
    float unused DIRT_DEFAULT(0.0f);
};

/// Direction from the eye to the point (\p x, \p y) of the image, in pixels; not of unit length.
DIRT_FUNCTION vec3 cameraDirection(ImagePlane plane, float x, float y) {
    DIRT_PRECISE float sx = plane.slopeX + x * plane.stepX;
    DIRT_PRECISE float sy = plane.slopeY + y * plane.stepY;
    DIRT_PRECISE vec3 direction = plane.right * sx + plane.down * sy + plane.forward;
    return direction;
}

/// The ray through a point of the lens that is chosen by \p u and \p v of [0, 1): where the ray
/// through the eye in the direction \p pinhole meets the focal plane, all cross.
DIRT_FUNCTION void lensRay(ImagePlane plane, vec3 pinhole, float u, float v, DIRT_OUT(vec3) origin,
                           DIRT_OUT(vec3) direction) {
    float sine;
    float cosine;
    sinCosTwoPi(v, sine, cosine);
    DIRT_PRECISE float radius = plane.lensRadius * sqrt(u);
    DIRT_PRECISE vec3 onLens = plane.right * (radius * cosine) + plane.down * (radius * sine);
    DIRT_PRECISE vec3 towards = pinhole - onLens / plane.focalDistance;
    origin = onLens;
    direction = towards;
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
