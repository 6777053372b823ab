#version 450 core
// Fetch, the rasterization of the triangles against the hit lists: one fragment is one tile that
// may list a triangle, by the coverage of FillPrimitives.

#include "include/proposed_tile.glsl"
#include "include/deposits.glsl"

void main() {
    if (gl_HelperInvocation) return; // reads nothing, so its search would have no end
    ivec2 tile = proposedTile();
    uint group = findGroup(uint(view), uint(tile.y * grid.columns + tile.x), primitive);
    if (group == kNoRecord) discard;
    vec2 depths;
    if (!tileLists(tile, depths)) discard;
    deposit(group, attributesOf(primitive));
}
