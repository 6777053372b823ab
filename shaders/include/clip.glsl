// The exact clip of core/grid/clip.h: a triangle's depths inside a guard-banded tile. The same
// operations in the same order; the derivation of its margin is there.

#include "include/coverage.glsl"
#include "shared/tile_clip.h"

/// The corners besides the vertices.
void clipPolygon(ViewTriangle triangle, vec2 s, vec2 t, inout ClippedDepths depths) {
    double e[12]; // [4 k + c]: edge k at corner c
    uint doubtful = 0u;
    for (int i = 0; i < 12; ++i) {
        int c = i % 4;
        bool sure;
        e[i] = edgeAtCorner(triangle.normals[i / 4], s[c & 1], t[c >> 1], sure);
        if (!sure) doubtful |= 1u << i;
    }
    while (doubtful != 0u) { // outside of the loop above, as it is rare
        int i = findLSB(doubtful), k = i / 4, c = i % 4;
        doubtful &= doubtful - 1u;
        // An edge without length, or through the eye, has no plane.
        e[i] = triangle.normals[k] == dvec3(0.0LF)
                   ? 0.0LF
                   : tripleProductExact(vec3(s[c & 1], t[c >> 1], 1.0), triangle.vertices[k],
                                        triangle.vertices[(k + 1) % 3]);
    }
    includePolygon(triangle.vertices, triangle.normals, triangle.determinant, s, t, e, depths);
}

/// The depths (near, far) of the triangle inside a tile with the given borders, rounded outwards.
/// False if nothing is left.
bool clipToTile(ViewTriangle triangle, vec2 s, vec2 t, out vec2 interval) {
    ClippedDepths depths = ClippedDepths(1.0e300LF, -1.0e300LF);
    if (!includeVertices(triangle.vertices, s, t, depths)) clipPolygon(triangle, s, t, depths);
    return listedDepths(depths, interval);
}
