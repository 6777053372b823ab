#include "core/grid/clip.h"

#include "core/grid/edges_at_corners.h"
#include "shaders/shared/tile_clip.h"

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

bool clipToTile(const ViewTriangle& triangle, const View& view, int column, int row,
                DepthInterval& out) {
    const glm::vec2 s(view.sLo[column], view.sHi[column]), t(view.tLo[row], view.tHi[row]);
    const auto& v = triangle.vertices;
    ClippedDepths depths;
    if (!includeVertices(v.data(), s, t, depths)) {
        double e[12];
        edgesAtCorners(triangle, s, t, e);
        includePolygon(v.data(), triangle.normals.data(), triangle.determinant, s, t, e, depths);
    }
    glm::vec2 listed;
    if (!listedDepths(depths, listed)) return false;
    out = {listed.x, listed.y};
    return true;
}

} // namespace dirt
