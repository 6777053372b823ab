#version 450 core
// FillDepth and FillPrimitives: proposes tiles that may list a triangle, to each view at once. The
// fragment shader decides. What is drawn covers the tiles that the side planes do not separate.

#include "include/coverage.glsl"

layout(triangles, invocations = DIRT_VIEWS) in;
layout(triangle_strip, max_vertices = 4) out;

in vec3 position[];

flat out vec3 vertexA, vertexB, vertexC;
flat out vec3 edgeA, edgeB, edgeC;
flat out uvec2 determinantBits;
flat out uint primitive;
flat out int view;

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
    gl_Position = vec4(place, 0.0, 1.0);
    EmitVertex();
}

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

    // Corners of the rectangle of tiles in [-1, 1]; the rasterizer looks at the tiles' centres.
    vec2 size = vec2(float(grid.columns), float(grid.rows));
    vec2 low = vec2(float(columns.x), float(rows.x)) / size * 2.0 - 1.0;
    vec2 high = vec2(float(columns.y + 1), float(rows.y + 1)) / size * 2.0 - 1.0;
    emit(triangle, low);
    emit(triangle, vec2(high.x, low.y));
    emit(triangle, vec2(low.x, high.y));
    emit(triangle, high);
    EndPrimitive();
}
