// The exact clip of core/grid/clip.h: a triangle's depths inside a guard-banded tile. The same
// operations in the same order; the derivation of its margin is there.

#include "include/coverage.glsl"

/// Depths found so far.
struct ClippedDepths {
    double near, far;
};

void include(inout ClippedDepths depths, double depth) {
    if (depth < depths.near) depths.near = depth;
    if (depth > depths.far) depths.far = depth;
}

int signOf(double x) {
    return int(x > 0.0LF) - int(x < 0.0LF);
}

/// n . (s, t, 1) for n = a × b, with a relative error of at most 2^-26; \p sure is false where
/// not even its sign is certain.
double edgeAtCorner(dvec3 n, float s, float t, out bool sure) {
    precise double x = n.x * double(s);
    precise double y = n.y * double(t);
    precise double value = (x + y) + n.z;
    precise double size = abs(x) + abs(y) + abs(n.z);
    sure = abs(value) > kSignDoubt * size;
    return value;
}

/// Signed distance of a vertex from a side of the tile, >= 0 inside. \p side 0: the border with
/// the smaller slope.
double sideDistance(vec3 vertex, int axis, int side, float slope) {
    precise double distance = double(vertex[axis]) - double(slope) * double(vertex.z);
    return side == 0 ? distance : -distance;
}

/// True if all three vertices are inside, and with them the triangle.
bool includeVertices(ViewTriangle triangle, vec2 s, vec2 t, inout ClippedDepths depths) {
    int inside = 0;
    for (int i = 0; i < 3; ++i) {
        vec3 v = triangle.vertices[i];
        if (v.z < 0.0) continue;
        if (sideDistance(v, 0, 0, s.x) < 0.0LF || sideDistance(v, 0, 1, s.y) < 0.0LF ||
            sideDistance(v, 1, 0, t.x) < 0.0LF || sideDistance(v, 1, 1, t.y) < 0.0LF)
            continue;
        include(depths, double(v.z));
        ++inside;
    }
    return inside == 3;
}

/// Where edge k crosses one side of the tile, between its corners with edge values p and q.
void includeCrossing(ViewTriangle triangle, int k, int axis, int side, float slope, double p,
                     double q, inout ClippedDepths depths) {
    if (signOf(p) * signOf(q) > 0) return;
    double da = sideDistance(triangle.vertices[k], axis, side, slope);
    double db = sideDistance(triangle.vertices[(k + 1) % 3], axis, side, slope);
    if (!((da < 0.0LF && db > 0.0LF) || (da > 0.0LF && db < 0.0LF))) return;
    double numerator = axis == 0 ? triangle.normals[k].y : -triangle.normals[k].x;
    precise double difference = side == 0 ? db - da : da - db;
    precise double depth = numerator / difference;
    if (depth >= 0.0LF) include(depths, depth); // else behind the eye
}

/// Where the ray through a corner meets the triangle, given its three edge values.
void includeCorner(double determinant, double ab, double bc, double ca,
                   inout ClippedDepths depths) {
    bool positive = ab > 0.0LF || bc > 0.0LF || ca > 0.0LF;
    bool negative = ab < 0.0LF || bc < 0.0LF || ca < 0.0LF;
    if (positive == negative) return;
    precise double sum = ab + bc + ca;
    precise double depth = determinant / sum;
    if (depth >= 0.0LF) include(depths, depth);
}

/// Corners are numbered (s0,t0), (s1,t0), (s0,t1), (s1,t1).
void includePolygon(ViewTriangle triangle, vec2 s, vec2 t, inout ClippedDepths depths) {
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
    for (int k = 0; k < 3; ++k) {
        includeCrossing(triangle, k, 0, 0, s.x, e[4 * k], e[4 * k + 2], depths);
        includeCrossing(triangle, k, 0, 1, s.y, e[4 * k + 1], e[4 * k + 3], depths);
        includeCrossing(triangle, k, 1, 0, t.x, e[4 * k], e[4 * k + 1], depths);
        includeCrossing(triangle, k, 1, 1, t.y, e[4 * k + 2], e[4 * k + 3], depths);
    }
    for (int c = 0; c < 4; ++c)
        includeCorner(triangle.determinant, e[c], e[4 + c], e[8 + c], depths);
}

/// The depths (near, far) of the triangle inside a tile with the given borders, rounded outwards.
/// False if nothing is left.
bool clipToTile(ViewTriangle triangle, vec2 s, vec2 t, out vec2 interval) {
    ClippedDepths depths = ClippedDepths(1.0e300LF, -1.0e300LF);
    if (!includeVertices(triangle, s, t, depths)) includePolygon(triangle, s, t, depths);
    interval = vec2(0.0);
    if (depths.far <= 0.0LF) return false; // nothing, or the eye alone, which is in no tile
    precise double near = depths.near * (1.0LF - kDepthMargin);
    precise double far = depths.far * (1.0LF + kDepthMargin);
    interval = vec2(roundDown(near), roundUp(far));
    return true;
}
