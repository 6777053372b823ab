// From where a point is seen, and what it then reflects of the light. DIRT_GLOSS says whether that
// matters.

#include "include/frame.glsl"
#include "include/points.glsl"
#include "shared/reflection.h"
#include "shared/surface.h"
#if DIRT_GLOSS
#include "shared/glossy_reflection.h"
#endif

#if DIRT_GLOSS
/// The unit vector from a point that the ray of a path event has found back along the ray. \p i: in
/// the piece.
vec3 towardsViewer(int event, uint i, SurfacePoint point) {
    if (event == 0 && frame.lens == 0u) return directionToEye(point.position);
    return -unitVector(rays[i].direction);
}
#endif

/// What the surface at G[k+1] reflects of the light, unless something is between them.
vec3 reflectedOfLight(uint i) {
    SurfacePoint point = nextPoint(i);
    LightSample light = sampleSpotlight(frame.light, point.position);
#if DIRT_GLOSS
    if (isGlossy(point))
        return reflectedRadiance(point, frame.microfacets, towardsViewer(frame.event, i, point),
                                 light);
#endif
    return reflectedRadiance(point, light);
}
