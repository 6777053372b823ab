// The path state, one record per image pixel (core/frame/path_buffers.h). A pass sees a piece of
// the records, and the bytes of all pixels.

#include "shared/layouts.h"

layout(std430, binding = 0) buffer RaysBlock {
    PathRay rays[];
};
layout(std430, binding = 1) buffer HitsBlock {
    Hit hits[];
};
#ifndef DIRT_POINT_WORDS
layout(std430, binding = 2) buffer CurrentBlock {
    SurfacePoint current[]; // G[k]
};
layout(std430, binding = 3) buffer NextBlock {
    SurfacePoint next[]; // G[k+1]
};
#endif
layout(std430, binding = 4) buffer RadianceBlock {
    float radiance[]; // three a pixel
};
layout(std430, binding = 5) buffer ImageBlock {
    float image[]; // three a pixel
};
layout(r8ui, binding = 2) uniform uimageBuffer mask;
layout(r8ui, binding = 3) uniform uimageBuffer visibility;

layout(location = 0) uniform uint firstPixel; // of the piece
layout(location = 1) uniform uint pixelCount;

const Hit kNoHit = Hit(kNoPrimitive, 0.0, 0.0, 0.0, 0u, 0u, 0u);
const PathRay kNoRay = PathRay(vec3(0.0), kNoPrimitive, vec3(0.0), 0.0, vec3(0.0), 0.0);
const SurfacePoint kNoPoint =
    SurfacePoint(vec3(0.0), kNoPrimitive, vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0,
                 vec3(0.0), 0u);

/// Whether the path of a pixel takes part in a path event. \p i: in the piece.
bool isAlive(int event, uint i) {
    return event == 0 || imageLoad(mask, int(firstPixel + i)).x != 0u;
}
