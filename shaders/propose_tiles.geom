#version 450 core
// FillDepth and FillPrimitives: proposes tiles that may list a triangle, to each view at once. The
// fragment shader decides. What is drawn covers the rectangle of tiles that the side planes do not
// separate; with DIRT_TRIANGLES 1, for conservative rasterization, large triangles themselves.

#include "include/coverage.glsl"
#include "include/proposal_parts.glsl"

layout(triangles, invocations = DIRT_VIEWS) in;
layout(triangle_strip, max_vertices = 4) out;

in vec3 position[];

flat out vec3 vertexA, vertexB, vertexC;
flat out vec3 edgeA, edgeB, edgeC;
flat out uvec2 determinantBits;
flat out uint primitive;
flat out int view;
#if DIRT_TRIANGLES
flat out ivec4 rectangle; // of tiles: column, row, columns, rows
flat out int part;        // see include/proposed_tile.glsl
#endif

/// \p place: column and row, with fractions.
void emit(ViewTriangle triangle, vec2 place) {
    vertexA = triangle.vertices[0];
    vertexB = triangle.vertices[1];
    vertexC = triangle.vertices[2];
    edgeA = triangle.edges[0];
    edgeB = triangle.edges[1];
    edgeC = triangle.edges[2];
    determinantBits = unpackDouble2x32(triangle.determinant);
    primitive = uint(gl_PrimitiveIDIn);
    view = gl_InvocationID;
    gl_Layer = gl_InvocationID;
    gl_Position = vec4(place / vec2(grid.columns, grid.rows) * 2.0 - 1.0, 0.0, 1.0);
    EmitVertex();
}

/// The two halves of a rectangle of tiles: the flat outputs of a half are those of its last vertex.
void emitRectangle(ViewTriangle triangle, ivec4 tiles) {
    vec2 low = vec2(tiles.xy), high = vec2(tiles.xy + tiles.zw);
#if DIRT_TRIANGLES
    rectangle = tiles;
    part = kFirstHalf;
#endif
    emit(triangle, low);
    emit(triangle, vec2(high.x, low.y));
    emit(triangle, vec2(low.x, high.y));
#if DIRT_TRIANGLES
    rectangle = tiles; // an emitted vertex leaves no outputs
    part = kSecondHalf;
#endif
    emit(triangle, high);
    EndPrimitive();
}

#if DIRT_TRIANGLES
/// Emits a triangle that is rather smaller than its rectangle of tiles, as far as that is safe:
/// places are off by less than 4 columns * 2^-21 <= 1/64 of a tile, by half a sub-pixel more after
/// snapping, and the guard band reaches 1/128 further, which a dilation by 1/4 covers all. What is
/// so thin that snapping may leave nothing of it is not emitted.
bool emitTriangle(ViewTriangle triangle, ivec2 extent) {
    if (extent.x < 4 || extent.y < 4) return false;
    vec2 place[3];
    for (int i = 0; i < 3; ++i) {
        vec3 v = triangle.vertices[i];
        if (v.z <= 0.0) return false;
        place[i] = v.xy / v.z * grid.tilesOfSlope.xy + grid.tilesOfSlope.zw;
        if (any(greaterThan(abs(place[i]), 4.0 * vec2(grid.columns, grid.rows)))) return false;
    }
    vec2 ab = place[1] - place[0], ac = place[2] - place[0];
    float width = abs(ab.x * ac.y - ab.y * ac.x) / (length(ab) + length(ac) + length(ab - ac));
    if (!(width > 0.125)) return false;
    for (int i = 0; i < 3; ++i) {
        rectangle = ivec4(0);
        part = kWhole;
        emit(triangle, place[i]);
    }
    EndPrimitive();
    return true;
}
#endif

void main() {
    vec3 vertices[3];
    for (int i = 0; i < 3; ++i) vertices[i] = toView(gl_InvocationID, position[i]);
    ViewTriangle triangle;
    Directions directions;
    if (!setUpTriangle(vertices, triangle, directions)) return;
    ivec2 columns = cellRange(directions, 0, 0, grid.columns);
    if (columns.x > columns.y) return;
    ivec2 rows = cellRange(directions, 1, grid.columns, grid.rows);
    if (rows.x > rows.y) return;

    ivec4 tiles = ivec4(columns.x, rows.x, columns.y - columns.x + 1, rows.y - rows.x + 1);
#if DIRT_TRIANGLES
    if (emitTriangle(triangle, tiles.zw)) return;
#endif
    emitRectangle(triangle, tiles);
}
