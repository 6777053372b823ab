// The id buffer: a list of (next, primitive) nodes for every (view, tile, bin), its head in layer
// view * bins + bin of a texture. Nodes lie in segments, as a buffer may be no longer than the
// driver allows.

const uint kNoNode = 0xffffffffu;

layout(std430, binding = 0) buffer Segment { // and the bindings that follow
    uvec2 nodes[];
} segments[DIRT_SEGMENTS];

// Which block is meant has to be the same in all lanes: so each goes through all.

void writeNode(uint node, uvec2 value) {
    uint place = node & ((1u << DIRT_SEGMENT_BITS) - 1u);
    for (uint i = 0u; i < DIRT_SEGMENTS; ++i)
        if (node >> DIRT_SEGMENT_BITS == i) segments[i].nodes[place] = value;
}

uvec2 readNode(uint node) {
    uint place = node & ((1u << DIRT_SEGMENT_BITS) - 1u);
    uvec2 value = uvec2(kNoNode);
    for (uint i = 0u; i < DIRT_SEGMENTS; ++i)
        if (node >> DIRT_SEGMENT_BITS == i) value = segments[i].nodes[place];
    return value;
}
