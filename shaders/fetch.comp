#version 450 core
// Fetch: G[k+1] of each hit, by primitive id (DIRT_RASTER 0), or from what the rasterized triangle
// has left with the records that name it (DIRT_RASTER 1).

#include "include/points.glsl"
#include "include/attributes.glsl"
#if DIRT_RASTER
#include "include/deposits.glsl"
#endif

layout(local_size_x = 64) in;

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= pixelCount) return;
    Hit hit = hits[i];
    clearNext(i);
    if (hit.primitive == kNoPrimitive) return;
#if DIRT_RASTER
    uint group = groupOf[i];
    uint fetched = fetches[group];
    hits[i].fetches = hit.fetches + fetched;
    if (fetched == 0u) return;
    Attributes attributes = deposited(group);
#else
    hits[i].fetches = hit.fetches + 1u;
    Attributes attributes = attributesOf(hit.primitive);
#endif
    setNext(i, surfaceAt(attributes, hit.primitive, hit.u, hit.v, rays[i].direction));
}
