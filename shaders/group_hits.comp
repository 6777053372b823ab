#version 450 core
// Fetch, before the triangles are rasterized: enters each hit record into the group of its tile and
// primitive.

#include "include/hit_groups.glsl"

layout(local_size_x = 64) in;

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= pixelCount) return;
    fetches[i] = 0u;
    groupOf[i] = kNoRecord;
    Hit hit = hits[i];
    if (hit.primitive == kNoPrimitive) return;
    uint slot = firstSlot(hit.view, hit.tile, hit.primitive);
    for (uint n = 0u; n <= slotMask; ++n, slot = nextSlot(slot)) {
        uint record = atomicCompSwap(slots[slot], kNoRecord, i);
        if (record == kNoRecord) record = i;
        if (record == i || isOf(hits[record], hit.view, hit.tile, hit.primitive)) {
            groupOf[i] = record;
            return;
        }
    }
}
