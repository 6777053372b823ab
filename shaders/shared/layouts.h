// Records of the frame's buffers: the same names, offsets and sizes in C++ and in GLSL (std430).
// A vec3 is always followed by a scalar that fills its row of 16 bytes.
#ifndef DIRT_SHARED_LAYOUTS_H
#define DIRT_SHARED_LAYOUTS_H

#include "shaders/shared/language.h"

DIRT_SHARED_BEGIN

/// "No primitive": a ray that skips nothing, a hit that is none, a point that is not there.
const uint kNoPrimitive = 0xffffffffu;

/// One record of the hit buffer: the nearest hit of a pixel's ray; at equal t the lowest primitive
/// id. A pixel has at most one, so its place in the buffer is its owner pixel.
struct Hit {
    uint primitive DIRT_DEFAULT(kNoPrimitive);
    float t DIRT_DEFAULT(0.0f);    // in units of the ray's direction
    float u DIRT_DEFAULT(0.0f);    // barycentric weight of vertex b
    float v DIRT_DEFAULT(0.0f);    // barycentric weight of vertex c
    uint view DIRT_DEFAULT(0u);    // the view and tile (row-major) that list the record; a view
    uint tile DIRT_DEFAULT(0u);    // beyond the last one is the eye itself (Grid::atEye)
    uint fetches DIRT_DEFAULT(0u); // how often Fetch has found the record: once, if all is well

#ifdef __cplusplus
    bool found() const {
        return primitive != kNoPrimitive;
    }
#endif
};

/// The ray of one pixel's path, in the grid frame; a direction of zero is the end of the path.
struct PathRay {
    vec3 origin DIRT_DEFAULT(0.0f);
    uint skip DIRT_DEFAULT(kNoPrimitive); // primitive the ray starts on, which it does not hit
    vec3 direction DIRT_DEFAULT(0.0f);
    float pdf DIRT_DEFAULT(0.0f);       // density of the direction over solid angle; 1 from the eye
    vec3 throughput DIRT_DEFAULT(0.0f); // weight of what the ray finds
    float unused DIRT_DEFAULT(0.0f);
};

/// A surface point of the shading buffer: G[k], in full precision. Positions and directions are in
/// the grid frame; the normals have unit length and lie on the side the ray came from.
struct SurfacePoint {
    vec3 position DIRT_DEFAULT(0.0f);
    uint primitive DIRT_DEFAULT(kNoPrimitive); // none: there is no point
    vec3 geometricNormal DIRT_DEFAULT(0.0f);
    float u DIRT_DEFAULT(0.0f); // barycentric weight of vertex b
    vec3 shadingNormal DIRT_DEFAULT(0.0f);
    float v DIRT_DEFAULT(0.0f);         // barycentric weight of vertex c
    vec3 diffuse DIRT_DEFAULT(0.0f);    // Kd or the texel of map_Kd, linear Rec.709
    float roughness DIRT_DEFAULT(0.0f); // of the microfacets; where the scene has gloss
    vec3 emission DIRT_DEFAULT(0.0f);   // Ke, radiance, on both sides
    uint gloss DIRT_DEFAULT(0u);        // reflectance and metallic (glossy_reflection.h), likewise

#ifdef __cplusplus
    bool found() const {
        return primitive != kNoPrimitive;
    }
#endif
};

DIRT_SHARED_END

#ifdef __cplusplus

#include <cstddef>

namespace dirt {
static_assert(sizeof(Hit) == 28 && offsetof(Hit, fetches) == 24);
static_assert(sizeof(PathRay) == 48 && offsetof(PathRay, skip) == 12 &&
              offsetof(PathRay, direction) == 16 && offsetof(PathRay, pdf) == 28 &&
              offsetof(PathRay, throughput) == 32);
static_assert(sizeof(SurfacePoint) == 80 && offsetof(SurfacePoint, primitive) == 12 &&
              offsetof(SurfacePoint, geometricNormal) == 16 && offsetof(SurfacePoint, u) == 28 &&
              offsetof(SurfacePoint, shadingNormal) == 32 && offsetof(SurfacePoint, v) == 44 &&
              offsetof(SurfacePoint, diffuse) == 48 && offsetof(SurfacePoint, emission) == 64);
} // namespace dirt

#endif

#endif
