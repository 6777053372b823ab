#version 450 core
// Rays: from the eye for event 0; else from G[k], in directions that its lobe chooses. One that
// would leave through the surface gets no direction: the path ends.

#include "include/paths.glsl"
#include "include/frame.glsl"
#include "include/triangles.glsl"
#include "include/offset.glsl"
#include "shared/random.h"
#include "shared/reflection.h"

layout(local_size_x = 64) in;

PathRay cameraRay(uint pixel) {
    vec3 direction = directionThrough(uvec2(pixel % frame.width, pixel / frame.width));
    return PathRay(vec3(0.0), kNoPrimitive, direction, 1.0, vec3(1.0), 0.0);
}

#if DIRT_SCATTERS
PathRay scatteredRay(uint pixel, SurfacePoint point, vec3 throughput) {
    uint event = uint(frame.event);
    float u = randomUnit(pixel, frame.sampleIndex, event, kDimensionScatterU, frame.seed);
    float v = randomUnit(pixel, frame.sampleIndex, event, kDimensionScatterV, frame.seed);
    Scattering next = scatter(point, u, v);
    if (next.direction == vec3(0.0)) return kNoRay;
    vec3 origin = offsetOrigin(triangleOf(point.primitive), point.u, point.v, next.direction);
    precise vec3 weight = throughput * next.weight;
    return PathRay(origin, point.primitive, next.direction, next.pdf, weight, 0.0);
}
#endif

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= pixelCount) return;
#if DIRT_SCATTERS
    if (!isAlive(frame.event, i))
        rays[i] = kNoRay;
    else
        rays[i] = scatteredRay(firstPixel + i, current[i],
                               frame.event == 1 ? vec3(1.0) : rays[i].throughput);
#else
    rays[i] = cameraRay(firstPixel + i);
#endif
}
