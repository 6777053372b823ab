#version 450 core
// ShadowMap: the depth at which the ray through the texel's centre hits the triangle, by the search's
// exact decision (core/frame/shadow_raster.h). Blending keeps the nearest.

#include "include/frame.glsl"
#include "shared/layouts.h"
#include "include/intersect.glsl"
#if DIRT_CUT_OUTS
#include "include/holes.glsl"
#endif

flat in uint primitive;

layout(location = 0) out float nearest;

void main() {
    uvec2 texel = uvec2(gl_FragCoord.xy);
    vec3 direction = shadowRayDirection(frame.light, frame.shadowMap, texel.x, texel.y);
    for (int i = 0; i < 3; ++i) direction[i] = flushed(direction[i]);
    Ray ray = Ray(frame.light.position, direction, kNoPrimitive);
    Triangle triangle = triangleOf(primitive);
    if (certainlyMisses(makeFilter(ray), ray, triangle)) discard;
    TriangleHit hit;
    if (!intersect(ray, triangle, hit) || !castsShadow(frame.shadowMap, hit.t)) discard;
#if DIRT_CUT_OUTS
    if (!isHit(-direction, primitive, hit.u, hit.v)) discard; // as the shadow ray, which comes back
#endif
    nearest = hit.t;
}
