#version 450 core
// DirectVisibility: the depth test is that of the rays' parameters, as the search computes them;
// at equal depth the triangle that is drawn first, which has the lowest id.

#include "include/frame.glsl"
#include "shared/layouts.h"
#include "include/triangles.glsl"
#include "include/seen_point.glsl"
#if DIRT_CUT_OUTS
#include "include/holes.glsl"
#endif

layout(location = 0) out uint seenPrimitive;

void main() {
    uint id = uint(gl_PrimitiveID);
    TriangleHit hit;
    Ray ray = primaryRay(directionThrough(uvec2(gl_FragCoord.xy)));
    if (!seenPoint(ray, triangleOf(id), hit)) discard;
#if DIRT_CUT_OUTS
    if (!isHit(ray.direction, id, hit.u, hit.v)) discard;
#endif
    seenPrimitive = id;
    gl_FragDepth = hit.t * 0.125; // exact, and below 1: no coordinate is 2 or more
}
