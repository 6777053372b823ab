// The hit lists that Fetch rasterizes against. Records of one tile that name one primitive form a
// group; groups are found by a hash table, so that a rasterized triangle finds its records at once
// however long a tile's list is, and leaves its attributes with them.

#include "include/paths.glsl"
#include "shared/random.h"

layout(std430, binding = 6) buffer SlotsBlock {
    uint slots[]; // the record that stands for a group, or kNoRecord; a power of two of them
};
layout(std430, binding = 7) buffer GroupOfBlock {
    uint groupOf[]; // of each record: the one that stands for its group
};
layout(std430, binding = 8) buffer FetchesBlock {
    uint fetches[]; // of the group that the record stands for
};

layout(location = 3) uniform uint slotMask; // slots less one

const uint kNoRecord = 0xffffffffu;

/// Where the search for a group begins.
uint firstSlot(uint view, uint tile, uint primitive) {
    uvec4 hash = pcg4d(uvec4(view, tile, primitive, 0u));
    return hash.x & slotMask;
}

uint nextSlot(uint slot) {
    return (slot + 1u) & slotMask;
}

bool isOf(Hit hit, uint view, uint tile, uint primitive) {
    return hit.primitive == primitive && hit.view == view && hit.tile == tile;
}

/// The group of a primitive in a tile, or kNoRecord. At least half of the slots are empty.
uint findGroup(uint view, uint tile, uint primitive) {
    uint slot = firstSlot(view, tile, primitive);
    for (uint i = 0u; i <= slotMask; ++i, slot = nextSlot(slot)) {
        uint record = slots[slot];
        if (record == kNoRecord || isOf(hits[record], view, tile, primitive)) return record;
    }
    return kNoRecord;
}
