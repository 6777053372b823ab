#include "core/grid/clip.h"

#include "core/grid/rounding.h"

#include <algorithm>
#include <array>

// Sutherland–Hodgman in double. The triangle itself is clipped, not its plane, so that edge-on
// triangles keep their depths and no depth leaves the triangle's own.
//
// Error. A plane distance d = x - s w has one rounding for a vertex (float products are exact) and
// 2^-53 |s w| more for a point made by an earlier cut: the plane moves by some 2^-52 of the slope,
// where the guard band leaves 3/512 of a tile, 2^-20 and more. A cut (p |d_q| + q d_p) / (d_p +
// |d_q|) weighs its depths with positive numbers: relative error below 2^-50 after four cuts. Its x
// and y may cancel, to an error of 2^-51 of the larger endpoint; that matters only where the point
// is nearer to the eye's plane than 2^-29 of the triangle's extent. kDepthMargin covers the depths.

namespace dirt {
namespace {

constexpr double kDepthMargin = 0x1p-48;

/// A triangle cut by five planes has at most eight corners.
struct Polygon {
    std::array<glm::dvec3, 8> points;
    int count = 0;
};

/// Keeps the part with distance >= 0.
template <class Distance>
void cut(Polygon& polygon, Distance distance) {
    Polygon out;
    for (int i = 0; i < polygon.count; ++i) {
        const glm::dvec3& p = polygon.points[i];
        const glm::dvec3& q = polygon.points[i + 1 < polygon.count ? i + 1 : 0];
        const double dp = distance(p), dq = distance(q);
        if (dp >= 0.0) out.points[out.count++] = p;
        if ((dp > 0.0 && dq < 0.0) || (dp < 0.0 && dq > 0.0)) {
            const double wp = std::abs(dq), wq = std::abs(dp);
            out.points[out.count++] = (p * wp + q * wq) / (wp + wq);
        }
    }
    polygon = out;
}

} // namespace

bool clipToTile(const ViewTriangle& triangle, const View& view, int column, int row,
                DepthInterval& out) {
    Polygon polygon;
    for (const glm::vec3& v : triangle.vertices) polygon.points[polygon.count++] = glm::dvec3(v);

    const double s0 = view.sLo[column], s1 = view.sHi[column];
    const double t0 = view.tLo[row], t1 = view.tHi[row];
    cut(polygon, [](const glm::dvec3& p) { return p.z; });
    cut(polygon, [=](const glm::dvec3& p) { return p.x - s0 * p.z; });
    cut(polygon, [=](const glm::dvec3& p) { return s1 * p.z - p.x; });
    cut(polygon, [=](const glm::dvec3& p) { return p.y - t0 * p.z; });
    cut(polygon, [=](const glm::dvec3& p) { return t1 * p.z - p.y; });
    if (polygon.count == 0) return false;

    double near = polygon.points[0].z, far = near;
    for (int i = 1; i < polygon.count; ++i) {
        near = std::min(near, polygon.points[i].z);
        far = std::max(far, polygon.points[i].z);
    }
    if (far <= 0.0) return false; // the eye alone is not part of the tile
    out.near = roundDown(near * (1.0 - kDepthMargin));
    out.far = roundUp(far * (1.0 + kDepthMargin));
    return true;
}

} // namespace dirt
