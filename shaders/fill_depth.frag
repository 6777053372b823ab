#version 450 core
// FillDepth: the depth bounds of every tile, as (-near, far) under blending by maximum.

#include "include/proposed_tile.glsl"

layout(location = 0) out vec2 bounds;

void main() {
    vec2 depths;
    if (!tileLists(proposedTile(), depths)) discard;
    bounds = vec2(-depths.x, depths.y);
}
