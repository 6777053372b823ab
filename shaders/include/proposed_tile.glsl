// What propose_tiles.geom hands to the fragment shaders of FillDepth and FillPrimitives: a triangle
// and a tile that may list it. One fragment is one tile of one view.

#include "include/clip.glsl"
#include "include/proposal_parts.glsl"

flat in vec3 vertexA, vertexB, vertexC; // in the view's frame
flat in vec3 edgeA, edgeB, edgeC;
flat in uvec2 determinantBits;
flat in uint primitive;
flat in int view;
#if DIRT_TRIANGLES
flat in ivec4 rectangle; // of tiles: column, row, columns, rows
flat in int part;
#endif

/// The tile of this fragment.
ivec2 proposedTile() {
    return ivec2(gl_FragCoord.xy);
}

/// Whether this fragment speaks for its tile. Conservative rasterization gives the tiles on the
/// diagonal of a rectangle to both halves, where ordinary rasterization gives each to one; that
/// half has it which covers its centre, the first where both do. Below: twice the area between the
/// tile's centre and the diagonal, in integers: 2 * 8192 * 8192 and less.
bool isOwnTile(ivec2 tile) {
#if DIRT_TRIANGLES
    if (part == kWhole) return true;
    ivec2 centre = 2 * (tile - rectangle.xy) + 1;
    bool first = centre.x * rectangle.w + centre.y * rectangle.z <= 2 * rectangle.z * rectangle.w;
    return first == (part == kFirstHalf);
#else
    return true;
#endif
}

/// The rule of both passes (core/grid/scan.h): whether the tile lists the triangle, and with which
/// depths (near, far).
bool tileLists(ivec2 tile, out vec2 depths) {
    depths = vec2(0.0);
    if (!isOwnTile(tile)) return false;
    vec2 s = columnBorders(tile.x), t = rowBorders(tile.y);
    ViewTriangle triangle;
    triangle.edges = vec3[3](edgeA, edgeB, edgeC);
    triangle.determinant = packDouble2x32(determinantBits);
    if (edgesSeparate(triangle.edges, triangle.determinant == 0.0LF, s, t)) return false;
    triangle.vertices = vec3[3](vertexA, vertexB, vertexC);
    setNormals(triangle);
    return clipToTile(triangle, s, t, depths);
}
