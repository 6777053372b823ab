#version 450 core
// FillPrimitives: enters a triangle into every bin that its part in a tile spans. Nodes that the
// pool has no room for are counted, not written; the pass is run again over a larger one.

#include "include/proposed_tile.glsl"
#include "include/nodes.glsl"
#include "shared/bins.h"

/// Depth bounds (-near, far).
layout(binding = 2) uniform sampler2DArray pyramid;

layout(r32ui, binding = 0) uniform uimage2DArray heads;

/// Nodes asked for (modulo 2^32), how often that sum has wrapped, and (triangle, tile) pairs.
layout(r32ui, binding = 1) uniform uimageBuffer counters;

/// Nodes that the pool has room for.
layout(location = 0) uniform uint capacity;

void main() {
    ivec2 tile = proposedTile();
    vec2 depths;
    if (!tileLists(tile, depths)) discard;
    vec2 bounds = texelFetch(pyramid, ivec3(tile, view), 0).xy;
    float perDepth = binsPerDepth(-bounds.x, bounds.y, grid.bins);
    int first = binOf(depths.x, -bounds.x, perDepth, grid.bins);
    int last = binOf(depths.y, -bounds.x, perDepth, grid.bins);

    uint count = uint(last - first + 1);
    uint node = imageAtomicAdd(counters, 0, count);
    imageAtomicAdd(counters, 2, 1u);
    if (node + count < node) imageAtomicAdd(counters, 1, 1u);
    if (node > capacity || capacity - node < count) return;
    for (int bin = first; bin <= last; ++bin, ++node) {
        uint next = imageAtomicExchange(heads, ivec3(tile, view * grid.bins + bin), node);
        writeNode(node, uvec2(next, primitive));
    }
}
