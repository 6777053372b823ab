#pragma once

#include "tests/gl/edited_shaders.h"

namespace dirt::test {

/// Proposals as drivers make them whose rasterization is conservative, and worse: no triangles, and
/// both halves of a rectangle reach all its tiles. For Proposal::triangles.
inline void overlapHalves(const EditedShaders& shaders) {
    const char* const file = "propose_tiles.geom";
    shaders.replace(file, "max_vertices = 4", "max_vertices = 8");
    shaders.replace(file, "if (emitTriangle(triangle, tiles.zw)) return;", "");
    shaders.replace(file, "    emitRectangle(triangle, tiles);", R"(
#if DIRT_TRIANGLES
    vec2 low = vec2(tiles.xy), high = vec2(tiles.xy + tiles.zw);
    for (int corner = 0; corner < 8; ++corner) {
        rectangle = tiles;
        part = corner < 4 ? kFirstHalf : kSecondHalf;
        emit(triangle, mix(low, high, bvec2((corner & 1) != 0, (corner & 2) != 0)));
        if (corner == 3) EndPrimitive();
    }
    EndPrimitive();
#else
    emitRectangle(triangle, tiles);
#endif)");
}

/// Takes the rule away by which one half speaks for a tile.
inline void ownAllTiles(const EditedShaders& shaders) {
    shaders.replace("include/proposed_tile.glsl", "return first == (part == kFirstHalf)",
                    "return true");
}

} // namespace dirt::test
