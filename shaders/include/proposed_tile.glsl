// What propose_tiles.geom hands to the fragment shaders of FillDepth and FillPrimitives: a triangle
// and a tile that may list it. One fragment is one tile of one view.

#include "include/clip.glsl"

flat in vec3 vertexA, vertexB, vertexC; // in the view's frame
flat in vec3 edgeA, edgeB, edgeC;
flat in uvec2 determinantBits;
flat in uint primitive;
flat in int view;

/// The tile of this fragment.
ivec2 proposedTile() {
    return ivec2(gl_FragCoord.xy);
}

/// The rule of both passes (core/grid/scan.h): whether the tile lists the triangle, and with which
/// depths (near, far).
bool tileLists(ivec2 tile, out vec2 depths) {
    depths = vec2(0.0);
    vec2 s = columnBorders(tile.x), t = rowBorders(tile.y);
    ViewTriangle triangle;
    triangle.edges = vec3[3](edgeA, edgeB, edgeC);
    triangle.determinant = packDouble2x32(determinantBits);
    if (edgesSeparate(triangle.edges, triangle.determinant == 0.0LF, s, t)) return false;
    triangle.vertices = vec3[3](vertexA, vertexB, vertexC);
    setNormals(triangle);
    return clipToTile(triangle, s, t, depths);
}
