#version 450 core
// Shade: adds what G[k+1] emits and reflects of the light, or the background, to the pixel's
// radiance. The scene's requirements leave out what it has none of.

#include "include/points.glsl"
#include "include/frame.glsl"
#include "include/viewer.glsl"

#if DIRT_SHADOW_MAP
layout(binding = 5) uniform sampler2D shadowMap;
#endif

layout(local_size_x = 64) in;

void add(uint i, vec3 radianceOfPixel) {
    for (uint c = 0u; c < 3u; ++c) {
        precise float sum = radiance[3u * i + c] + radianceOfPixel[c];
        radiance[3u * i + c] = boundedRadiance(sum);
    }
}

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= pixelCount) return;
    vec3 throughput = vec3(1.0);
#if DIRT_SECONDARY
    if (!isAlive(frame.event, i)) return;
    throughput = rays[i].throughput;
#endif
    bool found = foundNext(i);
    if (frame.rayType == kRaysVisibility) {
        if (!found) add(i, throughput);
        return;
    }
#if DIRT_EMISSION
    precise vec3 emitted = throughput * nextEmission(i);
    if (found) add(i, emitted);
#endif
#if DIRT_BACKGROUND
    precise vec3 seen = throughput * frame.background;
    if (!found) add(i, seen);
#endif
#if DIRT_SHADOW_MAP
    if (!found) return;
    vec3 reflected = reflectedOfLight(i);
    if (black(reflected)) return;
    SurfacePoint point = nextPoint(i);
    float open = openToLight(shadowMap, frame.light, frame.shadowMap, point.position,
                             point.geometricNormal);
    precise vec3 passing = reflected * open;
    precise vec3 arriving = throughput * passing;
    add(i, arriving);
#elif DIRT_LIGHT
#if DIRT_OPEN_LIGHT
    if (!found) return;
#else
    if (imageLoad(visibility, int(firstPixel + i)).x == 0u) return;
#endif
    vec3 reflected = reflectedOfLight(i);
    precise vec3 arriving = throughput * reflected;
    add(i, arriving);
#endif
}
