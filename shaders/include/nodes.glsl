// The id buffer: a list of (next, primitive) nodes for every (view, tile, bin), its head in
// layer view * bins + bin of a texture. Nodes lie in
// segments, as a buffer may be no longer than the driver allows.

const uint kNoNode = 0xffffffffu;

layout(std430, binding = 0) buffer Segment0 {
    uvec2 nodes0[];
};
#if DIRT_SEGMENTS > 1
layout(std430, binding = 1) buffer Segment1 {
    uvec2 nodes1[];
};
#endif
#if DIRT_SEGMENTS > 2
layout(std430, binding = 2) buffer Segment2 {
    uvec2 nodes2[];
};
#endif
#if DIRT_SEGMENTS > 3
layout(std430, binding = 3) buffer Segment3 {
    uvec2 nodes3[];
};
#endif
#if DIRT_SEGMENTS > 4
layout(std430, binding = 4) buffer Segment4 {
    uvec2 nodes4[];
};
#endif
#if DIRT_SEGMENTS > 5
layout(std430, binding = 5) buffer Segment5 {
    uvec2 nodes5[];
};
#endif
#if DIRT_SEGMENTS > 6
layout(std430, binding = 6) buffer Segment6 {
    uvec2 nodes6[];
};
#endif
#if DIRT_SEGMENTS > 7
layout(std430, binding = 7) buffer Segment7 {
    uvec2 nodes7[];
};
#endif
#if DIRT_SEGMENTS > 8
layout(std430, binding = 8) buffer Segment8 {
    uvec2 nodes8[];
};
#endif
#if DIRT_SEGMENTS > 9
layout(std430, binding = 9) buffer Segment9 {
    uvec2 nodes9[];
};
#endif
#if DIRT_SEGMENTS > 10
layout(std430, binding = 10) buffer Segment10 {
    uvec2 nodes10[];
};
#endif
#if DIRT_SEGMENTS > 11
layout(std430, binding = 11) buffer Segment11 {
    uvec2 nodes11[];
};
#endif
#if DIRT_SEGMENTS > 12
layout(std430, binding = 12) buffer Segment12 {
    uvec2 nodes12[];
};
#endif
#if DIRT_SEGMENTS > 13
layout(std430, binding = 13) buffer Segment13 {
    uvec2 nodes13[];
};
#endif
#if DIRT_SEGMENTS > 14
layout(std430, binding = 14) buffer Segment14 {
    uvec2 nodes14[];
};
#endif
#if DIRT_SEGMENTS > 15
layout(std430, binding = 15) buffer Segment15 {
    uvec2 nodes15[];
};
#endif

void writeNode(uint node, uvec2 value) {
    uint place = node & ((1u << DIRT_SEGMENT_BITS) - 1u);
    switch (node >> DIRT_SEGMENT_BITS) {
    case 0u: nodes0[place] = value; break;
#if DIRT_SEGMENTS > 1
    case 1u: nodes1[place] = value; break;
#endif
#if DIRT_SEGMENTS > 2
    case 2u: nodes2[place] = value; break;
#endif
#if DIRT_SEGMENTS > 3
    case 3u: nodes3[place] = value; break;
#endif
#if DIRT_SEGMENTS > 4
    case 4u: nodes4[place] = value; break;
#endif
#if DIRT_SEGMENTS > 5
    case 5u: nodes5[place] = value; break;
#endif
#if DIRT_SEGMENTS > 6
    case 6u: nodes6[place] = value; break;
#endif
#if DIRT_SEGMENTS > 7
    case 7u: nodes7[place] = value; break;
#endif
#if DIRT_SEGMENTS > 8
    case 8u: nodes8[place] = value; break;
#endif
#if DIRT_SEGMENTS > 9
    case 9u: nodes9[place] = value; break;
#endif
#if DIRT_SEGMENTS > 10
    case 10u: nodes10[place] = value; break;
#endif
#if DIRT_SEGMENTS > 11
    case 11u: nodes11[place] = value; break;
#endif
#if DIRT_SEGMENTS > 12
    case 12u: nodes12[place] = value; break;
#endif
#if DIRT_SEGMENTS > 13
    case 13u: nodes13[place] = value; break;
#endif
#if DIRT_SEGMENTS > 14
    case 14u: nodes14[place] = value; break;
#endif
#if DIRT_SEGMENTS > 15
    case 15u: nodes15[place] = value; break;
#endif
    }
}

uvec2 readNode(uint node) {
    uint place = node & ((1u << DIRT_SEGMENT_BITS) - 1u);
    switch (node >> DIRT_SEGMENT_BITS) {
    case 0u: return nodes0[place];
#if DIRT_SEGMENTS > 1
    case 1u: return nodes1[place];
#endif
#if DIRT_SEGMENTS > 2
    case 2u: return nodes2[place];
#endif
#if DIRT_SEGMENTS > 3
    case 3u: return nodes3[place];
#endif
#if DIRT_SEGMENTS > 4
    case 4u: return nodes4[place];
#endif
#if DIRT_SEGMENTS > 5
    case 5u: return nodes5[place];
#endif
#if DIRT_SEGMENTS > 6
    case 6u: return nodes6[place];
#endif
#if DIRT_SEGMENTS > 7
    case 7u: return nodes7[place];
#endif
#if DIRT_SEGMENTS > 8
    case 8u: return nodes8[place];
#endif
#if DIRT_SEGMENTS > 9
    case 9u: return nodes9[place];
#endif
#if DIRT_SEGMENTS > 10
    case 10u: return nodes10[place];
#endif
#if DIRT_SEGMENTS > 11
    case 11u: return nodes11[place];
#endif
#if DIRT_SEGMENTS > 12
    case 12u: return nodes12[place];
#endif
#if DIRT_SEGMENTS > 13
    case 13u: return nodes13[place];
#endif
#if DIRT_SEGMENTS > 14
    case 14u: return nodes14[place];
#endif
#if DIRT_SEGMENTS > 15
    case 15u: return nodes15[place];
#endif
    }
    return uvec2(kNoNode, kNoNode);
}
