// The overlap test of core/grid/coverage.h: the same operations in the same order, so that it gives
// the same bits. The derivation of its margins is there.

#include "include/arithmetic.glsl"
#include "include/exact_sum.glsl"
#include "include/views.glsl"
#include "shared/margins.h"
#include "shared/tile_coverage.h"

/// A triangle made ready for one view.
struct ViewTriangle {
    vec3 vertices[3];   // in the view's frame (x, y, w)
    vec3 edges[3];      // normals of the planes through the eye and ab, bc, ca, scaled
    dvec3 normals[3];   // the same, unscaled: exact but for one rounding
    double determinant; // a . (b × c), exact sign; zero: edge-on
};

/// The triangle's directions clipped at w >= 0, scaled: of the three vertices, and of where the
/// three edges cross w = 0. In place of those that do not exist stands another; so all indices are
/// constants, as places in memory cost more than directions.
struct Directions {
    vec3 at[6];
};

/// a × b; each component is the exact difference of two products, rounded once.
dvec3 edgeNormal(vec3 af, vec3 bf) {
    dvec3 a = dvec3(af), b = dvec3(bf);
    precise dvec3 normal =
        dvec3(a.y * b.z - b.y * a.z, a.z * b.x - b.z * a.x, a.x * b.y - b.x * a.y);
    return normal;
}

/// The vertices' edge normals.
void setNormals(inout ViewTriangle triangle) {
    for (int i = 0; i < 3; ++i)
        triangle.normals[i] = edgeNormal(triangle.vertices[i], triangle.vertices[(i + 1) % 3]);
}

double orientation(ViewTriangle triangle) {
    for (int i = 0; i < 3; ++i)
        if (triangle.normals[i] == dvec3(0.0LF)) return 0.0LF;
    for (int i = 0; i < 3; ++i) {
        precise dvec3 terms = triangle.normals[i] * dvec3(triangle.vertices[(i + 2) % 3]);
        precise double value = terms.x + terms.y + terms.z;
        precise double size = abs(terms.x) + abs(terms.y) + abs(terms.z);
        if (abs(value) > kSignDoubt * size) return value;
    }
    return tripleProductExact(triangle.vertices[0], triangle.vertices[1], triangle.vertices[2]);
}

/// False if no direction has w > 0.
bool clipDirections(vec3 vertices[3], out Directions directions) {
    bool inFront = false;
    vec3 any = vec3(0.0);
    for (int i = 0; i < 3; ++i) {
        vec3 a = vertices[i], b = vertices[(i + 1) % 3];
        inFront = inFront || a.z > 0.0;
        directions.at[i] = a.z >= 0.0 ? scaledToUnit(dvec3(a)) : vec3(0.0);
        bool crosses = (a.z < 0.0 && b.z > 0.0) || (a.z > 0.0 && b.z < 0.0);
        double wa = double(abs(a.z)), wb = double(abs(b.z));
        precise dvec2 crossing = dvec2(a.xy) * wb + dvec2(b.xy) * wa;
        directions.at[3 + i] = crosses ? scaledToUnit(dvec3(crossing, 0.0LF)) : vec3(0.0);
        if (a.z > 0.0) any = directions.at[i];
    }
    for (int i = 0; i < 6; ++i) // the eye itself is no direction either
        if (directions.at[i] == vec3(0.0)) directions.at[i] = any;
    return inFront;
}

/// False if nothing of the triangle has w > 0.
bool setUpTriangle(vec3 vertices[3], out ViewTriangle triangle, out Directions directions) {
    triangle.vertices = vertices;
    if (!clipDirections(vertices, directions)) return false;
    setNormals(triangle);
    triangle.determinant = orientation(triangle);
    for (int i = 0; i < 3; ++i)
        triangle.edges[i] = scaledToUnit(triangle.determinant < 0.0LF ? -triangle.normals[i]
                                                                      : triangle.normals[i]);
    return true;
}

/// Whether all directions lie strictly beyond a border of the given axis: on its small side (side
/// = -1) or on its large side (+1).
bool allBeyond(Directions directions, int axis, float slope, float side) {
    bool all = true;
    for (int i = 0; i < 6; ++i) {
        all = all && side * borderDistance(directions.at[i], axis, slope) > 0.0;
    }
    return all;
}

bool beyondBorder(Directions directions, int axis, int offset, int cell, float side) {
    vec2 border = texelFetch(borders, offset + cell).xy;
    return allBeyond(directions, axis, side > 0.0 ? border.y : border.x, side);
}

/// First and last cell of an axis that the side planes do not separate: from a guess onwards, as
/// the predicates are monotone. \p offset is where the axis begins in the borders.
ivec2 cellRange(Directions directions, int axis, int offset, int cells) {
    vec2 span = vec2(kLargest, -kLargest);
    for (int i = 0; i < 6; ++i) {
        float slope = directions.at[i][axis] / max(directions.at[i].z, 1.0e-30);
        span = vec2(min(span.x, slope), max(span.y, slope));
    }
    span = span * grid.tilesOfSlope[axis] + grid.tilesOfSlope[axis + 2];
    ivec2 range = ivec2(clamp(span, vec2(0.0), vec2(cells - 1)));
    while (range.x > 0 && !beyondBorder(directions, axis, offset, range.x - 1, 1.0)) --range.x;
    while (range.x < cells && beyondBorder(directions, axis, offset, range.x, 1.0)) ++range.x;
    while (range.y < cells - 1 && !beyondBorder(directions, axis, offset, range.y + 1, -1.0))
        ++range.y;
    while (range.y >= 0 && beyondBorder(directions, axis, offset, range.y, -1.0)) --range.y;
    return range;
}

/// Whether an edge plane of the triangle separates it from the guard-banded tile.
bool edgesSeparate(vec3 edges[3], bool edgeOn, vec2 s, vec2 t) {
    for (int i = 0; i < 3; ++i)
        if (edgeSeparates(edges[i], edgeOn, s, t)) return true;
    return false;
}
