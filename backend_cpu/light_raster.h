#pragma once

#include "backend_cpu/light_grid.h"

#include <algorithm>
#include <cmath>

namespace dirt {

// Where things lie in a face is said in units: 128ths of a tile, counted from the rim.
inline constexpr int kUnitShift = 7;
inline constexpr int kUnits = 1 << kUnitShift;

/// Tiles list what comes within so many units of them, and boxes are wider by as much. A ray may be
/// 0.93 away from where it is looked up (light_grid.cpp), edges are off by less than a half.
inline constexpr double kLightGuard = 1.5;

/// Ranges of no more tiles are listed whole, without a look at edges.
inline constexpr int kSmallLightRange = 4;

/// Depths rounded to float stay below what they bound.
inline constexpr double kBelow = 1.0 - 0x1p-20;

/// A triangle seen from the light: vertices less its position, and what follows from them, in
/// double. With |.| the largest component's norm, size and length as below, u = 2^-53: differences
/// have one rounding; a component of an edge's normal is off by less than 8 u size^2, one of the
/// triangle's normal by 8 u length^2, the determinant by 24 u length^2 size and 4 u |normal|_1
/// size.
struct LightTriangle {
    glm::dvec3 v[3];
    glm::dvec3 edges[3]; ///< normals of the planes through the light and an edge: v1 x v2, …
    glm::dvec3 normal;   ///< (b - a) x (c - a)
    double determinant;  ///< v0 . normal, its sign exact unless edgeOn
    bool edgeOn;         ///< the light may lie in the triangle's plane
    double size;         ///< largest |v|
    double length;       ///< largest |b - a|, |c - a|

    LightTriangle(const Triangle& triangle, const glm::vec3& light);
};

/// A box in a face, in units, both ends included.
struct UnitBox {
    int x0, x1, y0, y1;

    /// Its part in a tile, as in LightFragment.
    uint32_t in(int column, int row) const {
        const auto byte = [](int unit) { return (uint32_t) std::clamp(unit, 0, kUnits - 1); };
        const int x = column << kUnitShift, y = row << kUnitShift;
        return byte(x0 - x) | (kUnits - 1 - byte(x1 - x)) << 8 | byte(y0 - y) << 16 |
               (kUnits - 1 - byte(y1 - y)) << 24;
    }
};

/// The tiles of a face that a box meets.
struct LightRange {
    int column0, column1, row0, row1;

    LightRange(const UnitBox& box, const LightFace& face)
        : column0(std::max(box.x0 >> kUnitShift, face.column)),
          column1(std::min(box.x1 >> kUnitShift, face.column + face.columns - 1)),
          row0(std::max(box.y0 >> kUnitShift, face.row)),
          row1(std::min(box.y1 >> kUnitShift, face.row + face.rows - 1)) {}

    bool empty() const { return column0 > column1 || row0 > row1; }
    bool small() const { return (column1 - column0 + 1) * (row1 - row0 + 1) <= kSmallLightRange; }
};

inline uint32_t lightTile(const LightFace& face, int column, int row) {
    return face.firstTile + (uint32_t) (row - face.row) * (uint32_t) face.columns +
           (uint32_t) (column - face.column);
}

/// Calls emit(tile, near, box) for all tiles of a small range.
template <class Emit>
void emitSmall(const LightRange& range, const LightFace& face, const UnitBox& box, float near,
               Emit&& emit) {
    for (int row = range.row0; row <= range.row1; ++row)
        for (int column = range.column0; column <= range.column1; ++column)
            emit(lightTile(face, column, row), near, box.in(column, row));
}

/// Calls emit(tile, near, box) for at least all tiles of \p face that come within kLightGuard of a
/// part of the triangle with w >= \p clip. No point of that part in the widened tile is nearer than
/// `near`, or more than the guard outside the box. A superset of what core's `overlaps` says of the
/// view from the light, which has a narrower guard band.
template <class Emit>
void rasterFromLight(const LightTriangle& triangle, const LightFace& face, int tiles, double clip,
                     Emit&& emit) {
    const int x = face.axisX, y = face.axisY, w = face.axisW;
    const double sign = face.signW;
    const double step = 2.0 / tiles, guard = step * kLightGuard / kUnits;
    const double rim = 1.0 + 2.0 * guard;
    const glm::dvec3* const v = triangle.v;
    const auto outside = [&](auto&& side) { return side(v[0]) && side(v[1]) && side(v[2]); };
    if (outside([&](const glm::dvec3& p) { return sign * p[w] < clip; }) ||
        outside([&](const glm::dvec3& p) { return p[x] > rim * sign * p[w]; }) ||
        outside([&](const glm::dvec3& p) { return -p[x] > rim * sign * p[w]; }) ||
        outside([&](const glm::dvec3& p) { return p[y] > rim * sign * p[w]; }) ||
        outside([&](const glm::dvec3& p) { return -p[y] > rim * sign * p[w]; }))
        return;

    // The box of slopes of the part with w >= clip.
    double low[2] = {HUGE_VAL, HUGE_VAL}, high[2] = {-HUGE_VAL, -HUGE_VAL}, least = HUGE_VAL;
    const auto include = [&](double px, double py, double pw) {
        const double r = 1.0 / pw;
        low[0] = std::min(low[0], px * r), high[0] = std::max(high[0], px * r);
        low[1] = std::min(low[1], py * r), high[1] = std::max(high[1], py * r);
        least = std::min(least, pw);
    };
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3 &a = v[i], &b = v[(i + 1) % 3];
        const double wa = sign * a[w], wb = sign * b[w];
        if (wa >= clip) include(a[x], a[y], wa);
        if ((wa < clip) != (wb < clip)) {
            const double t = (clip - wa) / (wb - wa);
            include(a[x] + t * (b[x] - a[x]), a[y] + t * (b[y] - a[y]), clip);
        }
    }
    // Far beyond the rim, all is one.
    const double unitsPerSlope = 0.5 * kUnits * tiles, far = 2.0 * kUnits * tiles;
    const auto unitsOf = [&](double slope) {
        return std::clamp((slope + 1.0) * unitsPerSlope, -far, far);
    };
    const auto first = [&](double slope) { return (int) std::floor(unitsOf(slope) - kLightGuard); };
    const auto last = [&](double slope) { return (int) std::floor(unitsOf(slope) + kLightGuard); };
    UnitBox box{first(low[0]), last(high[0]), first(low[1]), last(high[1])};
    const LightRange range(box, face);
    if (range.empty()) return;
    if (range.small()) return emitSmall(range, face, box, (float) (least * kBelow), emit);

    // Row by row, between the edges: an edge's plane n . (s, t, 1) >= 0 taken at the border of the
    // widened row where it is largest leaves a bound of s, off by less than 2^-48 size^2 / |n_x|:
    // edges are heeded where that is less than half a unit. Edge-on triangles have no inner side.
    struct Edge {
        double t, constant, slope; ///< n_y, n_w, and -1/n_x
        int side;                  ///< s is bounded from below (1), above (-1), or not (0)
    } edges[3];
    const double orientation = triangle.determinant < 0.0 ? -1.0 : 1.0;
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3 n = orientation * triangle.edges[i];
        const bool clear =
            !triangle.edgeOn && std::abs(n[x]) * step > 0x1p-40 * triangle.size * triangle.size;
        edges[i] = {n[y], sign * n[w], clear ? -1.0 / n[x] : 0.0, clear ? n[x] > 0.0 ? 1 : -1 : 0};
    }
    // 1/w is affine in the slopes: (normal . (s, t, 1)) / determinant, largest in a tile's corner.
    // Both are taken where their errors are below 2^-24 of them.
    const glm::dvec3 n = orientation * triangle.normal;
    const double depth = std::abs(triangle.determinant);
    const double area = 0x1p-22 * triangle.length * triangle.length;
    const double unclear = depth > area * triangle.size ? area : HUGE_VAL;
    const double perColumn = n[x] * step;
    const int x0 = box.x0, x1 = box.x1;
    for (int row = range.row0; row <= range.row1; ++row) {
        const double t0 = row * step - 1.0 - guard, t1 = (row + 1) * step - 1.0 + guard;
        double from = low[0], to = high[0];
        for (const Edge& edge : edges) {
            const double bound = (std::max(edge.t * t0, edge.t * t1) + edge.constant) * edge.slope;
            if (edge.side > 0) from = std::max(from, bound);
            if (edge.side < 0) to = std::min(to, bound);
        }
        box.x0 = std::max(x0, first(from)), box.x1 = std::min(x1, last(to));
        const LightRange inRow(box, face);
        double inverse = std::max(n[y] * t0, n[y] * t1) + sign * n[w] +
                         n[x] * (inRow.column0 * step - 1.0) +
                         std::max(-n[x] * guard, n[x] * (step + guard));
        for (int column = inRow.column0; column <= inRow.column1; ++column, inverse += perColumn) {
            double near = least;
            if (inverse > unclear) near = std::max(near, depth / inverse);
            emit(lightTile(face, column, row), (float) (near * kBelow), box.in(column, row));
        }
    }
}

/// The fragments of triangles [begin, end) in \p grid, whose faces are set; writes the records of
/// those that have any. Three vertices well inside a face are looked at in SIMD.
void scanFromLight(const FrameGeometry& geometry, LightGrid& grid, size_t begin, size_t end,
                   LightPiece& piece);

} // namespace dirt
