#include "core/explain/clip_polygon.h"

#include "core/grid/edges_at_corners.h"
#include "shaders/shared/tile_clip.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>

namespace dirt {

namespace {

/// Asks the functions of the clip for one corner after the other, so that what they find is its
/// depth alone.
class CutTriangle {
public:
    CutTriangle(const ViewTriangle& triangle, const View& view, int column, int row)
        : triangle_(triangle), s_(view.sLo[column], view.sHi[column]),
          t_(view.tLo[row], view.tHi[row]) {
        edgesAtCorners(triangle, s_, t_, e_);
    }

    std::vector<glm::dvec3> all() const {
        std::vector<glm::dvec3> points;
        const auto add = [&](const std::optional<glm::dvec3>& point) {
            if (point) points.push_back(*point);
        };
        for (int i = 0; i < 3; ++i) add(vertex(i));
        if (points.size() == 3) return points;
        for (int k = 0; k < 3; ++k)
            for (int side = 0; side < 4; ++side) add(crossing(k, side >> 1, side & 1));
        for (int c = 0; c < 4; ++c) add(corner(c));
        return points;
    }

private:
    /// Vertex \p i, if it is inside.
    std::optional<glm::dvec3> vertex(int i) const {
        const glm::vec3 v = triangle_.vertices[i], same[3] = {v, v, v};
        ClippedDepths depths;
        if (!includeVertices(same, s_, t_, depths)) return {};
        return glm::dvec3(v);
    }

    /// Where edge \p k crosses a side of the tile, but for its corners, which are points of their
    /// own.
    std::optional<glm::dvec3> crossing(int k, int axis, int side) const {
        const int p = axis == 0 ? side : 2 * side, q = axis == 0 ? p + 2 : p + 1;
        if ((e_[4 * k + p] == 0.0 && corner(p)) || (e_[4 * k + q] == 0.0 && corner(q))) return {};
        const glm::vec3 a = triangle_.vertices[k], b = triangle_.vertices[(k + 1) % 3];
        const float slope = (axis == 0 ? s_ : t_)[side];
        ClippedDepths depths;
        includeCrossing(a, b, triangle_.normals[k], axis, side, slope, e_[4 * k + p], e_[4 * k + q],
                        depths);
        if (depths.far < 0.0) return {};
        // The other coordinate divides the edge as the distances of its ends do, of which one is
        // inside and one outside.
        const double da = std::abs(sideDistance(a, axis, side, slope));
        const double db = std::abs(sideDistance(b, axis, side, slope));
        const int other = 1 - axis;
        glm::dvec3 point;
        point[axis] = (double) slope * depths.far;
        point[other] = ((double) a[other] * db + (double) b[other] * da) / (da + db);
        point.z = depths.far;
        return point;
    }

    /// Where the ray through corner \p c of the tile meets the triangle.
    std::optional<glm::dvec3> corner(int c) const {
        ClippedDepths depths;
        includeCorner(triangle_.determinant, e_[c], e_[4 + c], e_[8 + c], depths);
        if (depths.far < 0.0) return {};
        return glm::dvec3((double) s_[c & 1], (double) t_[c >> 1], 1.0) * depths.far;
    }

    const ViewTriangle& triangle_;
    glm::vec2 s_, t_;
    double e_[12];
};

} // namespace

std::vector<glm::dvec3> clippedPolygon(const ViewTriangle& triangle, const View& view, int column,
                                       int row) {
    DepthInterval depths;
    if (!clipToTile(triangle, view, column, row, depths)) return {};
    std::vector<glm::dvec3> points = CutTriangle(triangle, view, column, row).all();
    if (points.size() < 2) return points;
    const auto& v = triangle.vertices;
    const glm::dvec3 a(v[0]), ab = glm::dvec3(v[1]) - a, ac = glm::dvec3(v[2]) - a;
    const glm::dvec3 longest = glm::dot(ab, ab) > glm::dot(ac, ac) ? ab : ac;
    const glm::dvec3 normal = glm::cross(ab, ac);
    if (normal == glm::dvec3(0.0)) { // along the line
        std::sort(points.begin(), points.end(), [&](glm::dvec3 p, glm::dvec3 q) {
            return glm::dot(p, longest) < glm::dot(q, longest);
        });
        return points;
    }
    glm::dvec3 middle(0.0);
    for (const glm::dvec3& point : points) middle += point;
    middle /= (double) points.size();
    const glm::dvec3 across = glm::normalize(glm::cross(normal, longest));
    const glm::dvec3 along = glm::normalize(longest);
    const auto angle = [&](glm::dvec3 p) {
        return std::atan2(glm::dot(p - middle, across), glm::dot(p - middle, along));
    };
    std::sort(points.begin(), points.end(),
              [&](glm::dvec3 a, glm::dvec3 b) { return angle(a) < angle(b); });
    return points;
}

} // namespace dirt
