#include "core/grid/clip.h"

#include "core/base/exact_sum.h"
#include "shaders/shared/margins.h"
#include "shaders/shared/rounding.h"

#include <algorithm>
#include <array>
#include <cmath>

// The triangle itself is clipped, not its plane, so that edge-on triangles keep their depths. The
// corners of the clipped polygon are of three kinds, and each is found from the inputs directly, so
// that no error is carried from cut to cut:
//
// - a vertex inside the tile;
// - an edge ab crossing a side x = s w between two corners of the tile. With d = x - s w and
//   n = a × b it lies at depth w = n_y / (d_b - d_a) (for a side y = t w: -n_x / (d_b - d_a)), and
//   between the corners p and q if n . p and n . q have not the same sign;
// - a corner ray c through the triangle: all n_k . c have the same sign; w = det / sum n_k . c.
//
// Signs are exact: d is a difference of two exact products, rounded once; so are the components of
// n; n . c is a sum of products of three floats, done exactly where double is in doubt. Hence the
// polygon's topology is exact for the guard-banded tile, on the eye's plane and through the eye
// too. Depths: d_b and d_a have opposite signs, the n_k . c the same, so nothing cancels. det has a
// relative error of 2.5 * 2^-27 at most, the n_k . c one of 2 * 2^-27 (as the third component meets
// no product), and all else some roundings of double: the depth is good for 4.5 * 2^-27 and little
// more, below 2^-24.

namespace dirt {
namespace {

int sign(double x) {
    return (x > 0.0) - (x < 0.0);
}

/// n . (s, t, 1) for n = a × b: relative error at most 2^-26, exact sign.
double edgeAtCorner(const glm::dvec3& n, glm::vec3 a, glm::vec3 b, float s, float t) {
    const double x = n.x * s, y = n.y * t;
    const double value = (x + y) + n.z;
    if (std::abs(value) > kSignDoubt * (std::abs(x) + std::abs(y) + std::abs(n.z))) return value;
    if (n == glm::dvec3(0.0)) return 0.0;
    return tripleProductExact({s, t, 1.0f}, a, b);
}

/// A triangle against one guard-banded tile.
struct TileClip {
    const ViewTriangle& triangle;
    std::array<float, 2> s, t;
    double near = HUGE_VAL, far = -HUGE_VAL;

    void include(double depth) {
        near = std::min(near, depth);
        far = std::max(far, depth);
    }

    /// Signed distance of a vertex from a side, >= 0 inside. Axis 0: x against s, 1: y against t.
    double distance(int vertex, int axis, int side) const {
        const glm::vec3& v = triangle.vertices[vertex];
        const double slope = axis == 0 ? s[side] : t[side];
        const double d = (double) v[axis] - slope * v.z;
        return side == 0 ? d : -d;
    }

    /// True if all three vertices are inside, and with them the triangle.
    bool includeVertices() {
        int inside = 0;
        for (int v = 0; v < 3; ++v) {
            if (triangle.vertices[v].z < 0.0f) continue;
            if (distance(v, 0, 0) < 0.0 || distance(v, 0, 1) < 0.0 || distance(v, 1, 0) < 0.0 ||
                distance(v, 1, 1) < 0.0)
                continue;
            include(triangle.vertices[v].z);
            ++inside;
        }
        return inside == 3;
    }

    /// edges[k] . corner, corners in the order (s0,t0), (s1,t0), (s0,t1), (s1,t1).
    std::array<std::array<double, 4>, 3> edgesAtCorners() const {
        std::array<std::array<double, 4>, 3> e;
        for (int k = 0; k < 3; ++k)
            for (int c = 0; c < 4; ++c)
                e[k][c] = edgeAtCorner(triangle.normals[k], triangle.vertices[k],
                                       triangle.vertices[(k + 1) % 3], s[c & 1], t[c >> 1]);
        return e;
    }

    /// Where edge k crosses one side of the tile, between its corners with e = \p p and \p q.
    void includeCrossing(int k, int axis, int side, double p, double q) {
        if (sign(p) * sign(q) > 0) return;
        const double da = distance(k, axis, side), db = distance((k + 1) % 3, axis, side);
        if (!((da < 0.0 && db > 0.0) || (da > 0.0 && db < 0.0))) return;
        const glm::dvec3& n = triangle.normals[k];
        const double numerator = axis == 0 ? n.y : -n.x;
        const double depth = numerator / (side == 0 ? db - da : da - db);
        if (depth >= 0.0) include(depth); // else behind the eye
    }

    /// Where the ray through a corner meets the triangle, given its three edge values.
    void includeCorner(double ab, double bc, double ca) {
        const bool positive = ab > 0.0 || bc > 0.0 || ca > 0.0;
        const bool negative = ab < 0.0 || bc < 0.0 || ca < 0.0;
        if (positive == negative) return;
        const double depth = triangle.determinant / (ab + bc + ca);
        if (depth >= 0.0) include(depth);
    }
};

} // namespace

bool clipToTile(const ViewTriangle& triangle, const View& view, int column, int row,
                DepthInterval& out) {
    TileClip clip{triangle, {view.sLo[column], view.sHi[column]}, {view.tLo[row], view.tHi[row]}};
    if (!clip.includeVertices()) {
        const auto e = clip.edgesAtCorners();
        for (int k = 0; k < 3; ++k) {
            clip.includeCrossing(k, 0, 0, e[k][0], e[k][2]);
            clip.includeCrossing(k, 0, 1, e[k][1], e[k][3]);
            clip.includeCrossing(k, 1, 0, e[k][0], e[k][1]);
            clip.includeCrossing(k, 1, 1, e[k][2], e[k][3]);
        }
        for (int c = 0; c < 4; ++c) clip.includeCorner(e[0][c], e[1][c], e[2][c]);
    }
    if (clip.far <= 0.0) return false; // nothing, or the eye alone, which is in no tile
    out.near = roundDown(clip.near * (1.0 - kDepthMargin));
    out.far = roundUp(clip.far * (1.0 + kDepthMargin));
    return true;
}

} // namespace dirt
