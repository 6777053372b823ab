// The rays of a cast, and where their hits go: those of paths (DIRT_PATHS 1), or any others.

#include "include/ray_record.glsl"
#include "shared/layouts.h"

layout(std430, binding = DIRT_SEGMENTS) readonly buffer Rays {
#if DIRT_PATHS
    PathRay rays[];
#else
    RayRecord rays[];
#endif
};
layout(std430, binding = DIRT_SEGMENTS + 1) buffer Hits {
    Hit hits[];
};
#if DIRT_PATHS
layout(binding = 8) uniform usamplerBuffer mask; // of all pixels
#endif

layout(location = 0) uniform uint count;
layout(location = 6) uniform bool masked; // paths: only those that the mask leaves alive
layout(location = 7) uniform uint firstPixel; // paths: that of the first ray

const Hit kNoHit = Hit(kNoPrimitive, 0.0, 0.0, 0.0, 0u, 0u, 0u);

RayRecord rayOf(uint index) {
#if DIRT_PATHS
    PathRay ray = rays[index];
    bool alive = !masked || texelFetch(mask, int(firstPixel + index)).x != 0u;
    return RayRecord(ray.origin, ray.skip, alive ? ray.direction : vec3(0.0), 0.0);
#else
    return rays[index];
#endif
}
