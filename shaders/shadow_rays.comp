#version 450 core
// The first part of Visibility: shadow rays from G[k+1] to the light, where it would add something.
// In single mode they end where they leave the view.

#include "include/points.glsl"
#include "include/frame.glsl"
#include "include/triangles.glsl"
#include "include/offset.glsl"
#include "include/ray_record.glsl"
#include "include/viewer.glsl"
#if DIRT_SINGLE
#include "include/view_cone.glsl"
#endif

layout(local_size_x = 64) in;

layout(std430, binding = 6) writeonly buffer ShadowRaysBlock {
    RayRecord shadowRays[];
};
layout(std430, binding = 7) buffer CountBlock {
    uint asked;
};

/// Whether the light would add something, if it were seen.
bool isLit(uint i) {
    if (!isAlive(frame.event, i) || !foundNext(i)) return false;
    return !black(reflectedOfLight(i));
}

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= pixelCount) return;
    bool lit = isLit(i);
    imageStore(visibility, int(firstPixel + i), uvec4(lit ? 1u : 0u)); // until it is occluded
    if (!lit) {
        shadowRays[i] = RayRecord(vec3(0.0), kNoPrimitive, vec3(0.0), -1.0);
        return;
    }
    atomicAdd(asked, 1u);
    SurfacePoint point = nextPoint(i);
    precise vec3 toLight = frame.light.position - point.position;
    vec3 origin = offsetOrigin(triangleOf(point.primitive), point.u, point.v, toLight);
    precise vec3 direction = frame.light.position - origin;
    float end = 1.0;
#if DIRT_SINGLE
    end = min(partInView(Ray(origin, direction, point.primitive)).y, 1.0);
#endif
    shadowRays[i] = RayRecord(origin, point.primitive, direction, end);
}
