// The corners of a triangle clipped to a guard-banded tile, and their depths. core/grid/clip.cpp
// says why there are three kinds of them, and how exact they are.
#ifndef DIRT_SHARED_TILE_CLIP_H
#define DIRT_SHARED_TILE_CLIP_H

#include "shaders/shared/margins.h"
#include "shaders/shared/rounding.h"

DIRT_SHARED_BEGIN

/// Depths found so far.
struct ClippedDepths {
    double near DIRT_DEFAULT(1.0e300);
    double far DIRT_DEFAULT(-1.0e300);
};

DIRT_FUNCTION void includeDepth(DIRT_INOUT(ClippedDepths) depths, double depth) {
    if (depth < depths.near) depths.near = depth;
    if (depth > depths.far) depths.far = depth;
}

/// Signed distance of a vertex from a side of the tile, >= 0 inside. \p axis 0: x against s, 1: y
/// against t; \p side 0: the border with the smaller slope.
DIRT_FUNCTION double sideDistance(vec3 vertex, int axis, int side, float slope) {
    DIRT_PRECISE double distance = double(vertex[axis]) - double(slope) * double(vertex.z);
    return side == 0 ? distance : -distance;
}

/// Takes in the vertices inside. True if all three are, and with them the triangle.
DIRT_FUNCTION bool includeVertices(const vec3 vertices[3], vec2 s, vec2 t,
                                   DIRT_INOUT(ClippedDepths) depths) {
    int inside = 0;
    for (int i = 0; i < 3; ++i) {
        vec3 v = vertices[i];
        if (v.z < 0.0f) continue;
        if (sideDistance(v, 0, 0, s.x) < 0.0 || sideDistance(v, 0, 1, s.y) < 0.0 ||
            sideDistance(v, 1, 0, t.x) < 0.0 || sideDistance(v, 1, 1, t.y) < 0.0)
            continue;
        includeDepth(depths, double(v.z));
        ++inside;
    }
    return inside == 3;
}

/// n . (s, t, 1) for n = a × b, with a relative error of at most 2^-26; \p sure is false where not
/// even its sign is certain.
DIRT_FUNCTION double edgeAtCorner(dvec3 n, float s, float t, DIRT_OUT(bool) sure) {
    DIRT_PRECISE double x = n.x * double(s);
    DIRT_PRECISE double y = n.y * double(t);
    DIRT_PRECISE double value = (x + y) + n.z;
    DIRT_PRECISE double size = abs(x) + abs(y) + abs(n.z);
    sure = abs(value) > kSignDoubt * size;
    return value;
}

/// Where the edge from \p a to \p b, \p n = a × b, crosses one side of the tile, between its
/// corners with edge values \p p and \p q.
DIRT_FUNCTION void includeCrossing(vec3 a, vec3 b, dvec3 n, int axis, int side, float slope,
                                   double p, double q, DIRT_INOUT(ClippedDepths) depths) {
    if (signOf(p) * signOf(q) > 0) return;
    double da = sideDistance(a, axis, side, slope);
    double db = sideDistance(b, axis, side, slope);
    if (signOf(da) * signOf(db) >= 0) return;
    double numerator = axis == 0 ? n.y : -n.x;
    DIRT_PRECISE double difference = side == 0 ? db - da : da - db;
    DIRT_PRECISE double depth = numerator / difference;
    if (depth >= 0.0) includeDepth(depths, depth); // else behind the eye
}

/// Where the ray through a corner meets the triangle, given its three edge values.
DIRT_FUNCTION void includeCorner(double determinant, double ab, double bc, double ca,
                                 DIRT_INOUT(ClippedDepths) depths) {
    bool positive = ab > 0.0 || bc > 0.0 || ca > 0.0;
    bool negative = ab < 0.0 || bc < 0.0 || ca < 0.0;
    if (positive == negative) return;
    DIRT_PRECISE double sum = ab + bc + ca;
    DIRT_PRECISE double depth = determinant / sum;
    if (depth >= 0.0) includeDepth(depths, depth);
}

/// The corners besides the vertices. \p e: [4 k + c] is the value of edge k at corner c, in the
/// order (s0,t0), (s1,t0), (s0,t1), (s1,t1).
DIRT_FUNCTION void includePolygon(const vec3 vertices[3], const dvec3 normals[3],
                                  double determinant, vec2 s, vec2 t, const double e[12],
                                  DIRT_INOUT(ClippedDepths) depths) {
    for (int k = 0; k < 3; ++k) {
        vec3 a = vertices[k], b = vertices[(k + 1) % 3];
        dvec3 n = normals[k];
        includeCrossing(a, b, n, 0, 0, s.x, e[4 * k], e[4 * k + 2], depths);
        includeCrossing(a, b, n, 0, 1, s.y, e[4 * k + 1], e[4 * k + 3], depths);
        includeCrossing(a, b, n, 1, 0, t.x, e[4 * k], e[4 * k + 1], depths);
        includeCrossing(a, b, n, 1, 1, t.y, e[4 * k + 2], e[4 * k + 3], depths);
    }
    for (int c = 0; c < 4; ++c) includeCorner(determinant, e[c], e[4 + c], e[8 + c], depths);
}

/// The depths (near, far), rounded outwards. False if nothing is left, or the eye alone, which is
/// in no tile.
DIRT_FUNCTION bool listedDepths(ClippedDepths depths, DIRT_OUT(vec2) interval) {
    interval = vec2(0.0f);
    if (depths.far <= 0.0) return false;
    DIRT_PRECISE double near = depths.near * (1.0 - kDepthMargin);
    DIRT_PRECISE double far = depths.far * (1.0 + kDepthMargin);
    interval = vec2(roundDown(near), roundUp(far));
    return true;
}

DIRT_SHARED_END

#endif
