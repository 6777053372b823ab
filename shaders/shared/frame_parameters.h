// What the passes of a sample need to know of the frame, the sample and the path event (std140).
#ifndef DIRT_SHARED_FRAME_PARAMETERS_H
#define DIRT_SHARED_FRAME_PARAMETERS_H

#include "shaders/shared/image_plane.h"
#include "shaders/shared/shadow_map.h"

DIRT_SHARED_BEGIN

struct FrameParameters {
    ImagePlane plane;
    GridSpotlight light;
    vec3 right DIRT_DEFAULT(0.0f); // rows of the rotation from world axes to the grid frame's;
    uint single DIRT_DEFAULT(0u);  //   1: the frame is the camera's, 0: there is no rotation
    vec3 down DIRT_DEFAULT(0.0f);
    uint width DIRT_DEFAULT(0u); // of the image, in pixels
    vec3 forward DIRT_DEFAULT(0.0f);
    uint seed DIRT_DEFAULT(0u);
    vec3 background DIRT_DEFAULT(0.0f);
    int event DIRT_DEFAULT(0);
    float offsetX DIRT_DEFAULT(0.0f); // of the sample, from a pixel's corner
    float offsetY DIRT_DEFAULT(0.0f);
    uint sampleIndex DIRT_DEFAULT(0u);
    uint microfacets DIRT_DEFAULT(0u); // the scene's model
    uint rayType DIRT_DEFAULT(0u);     // what indirect rays take surfaces for
    uint roulette DIRT_DEFAULT(0u);    // 1: paths beyond three bounces go on by chance
    uint lens DIRT_DEFAULT(0u);        // 1: the camera has an aperture
    uint unused DIRT_DEFAULT(0u);
    ShadowMap shadowMap;
};

DIRT_SHARED_END

#ifdef __cplusplus

#include <cstddef>

namespace dirt {
static_assert(sizeof(FrameParameters) == 272 && offsetof(FrameParameters, light) == 64 &&
              offsetof(FrameParameters, right) == 144 && offsetof(FrameParameters, width) == 172 &&
              offsetof(FrameParameters, background) == 192 &&
              offsetof(FrameParameters, offsetX) == 208 &&
              offsetof(FrameParameters, shadowMap) == 240);
} // namespace dirt

#endif

#endif
