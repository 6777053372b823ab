#pragma once

#include "backend_cpu/light_grid.h"

#include <algorithm>
#include <cmath>

namespace dirt {

/// Tiles list what comes within this part of a tile of them.
inline constexpr double kLightGuard = 1.0 / 16.0;

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

/// Calls emit(tile, near) for at least all tiles of \p face that come within kLightGuard of a tile
/// of a part of the triangle with w >= \p clip. No point of that part in the widened tile is nearer
/// than `near`. A superset of what core's `overlaps` says of the view from the light, which has a
/// narrower guard band.
template <class Emit>
void rasterFromLight(const LightTriangle& triangle, const LightFace& face, int tiles, double clip,
                     Emit&& emit) {
    // Rounded to float depths stay below what they bound.
    constexpr double kBelow = 1.0 - 0x1p-20;
    const int x = face.axisX, y = face.axisY, w = face.axisW;
    const double sign = face.signW;
    const double rim = 1.0 + 2.0 * kLightGuard / tiles;
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
    const auto toTiles = [&](double slope) { return (slope + 1.0) * 0.5 * tiles; };
    const auto first = [&](double tile, int from, int count) {
        return (int) std::clamp(std::floor(tile - kLightGuard), (double) from,
                                (double) (from + count));
    };
    const auto last = [&](double tile, int from, int count) {
        return (int) std::clamp(std::floor(tile + kLightGuard), from - 1.0,
                                (double) (from + count - 1));
    };
    const int column0 = first(toTiles(low[0]), face.column, face.columns);
    const int column1 = last(toTiles(high[0]), face.column, face.columns);
    const int row0 = first(toTiles(low[1]), face.row, face.rows);
    const int row1 = last(toTiles(high[1]), face.row, face.rows);
    if (column0 > column1 || row0 > row1) return;
    const auto tileAt = [&](int column, int row) {
        return face.firstTile + (uint32_t) (row - face.row) * (uint32_t) face.columns +
               (uint32_t) (column - face.column);
    };
    if (column0 == column1 && row0 == row1) {
        emit(tileAt(column0, row0), (float) (least * kBelow));
        return;
    }

    // Row by row, between the edges: an edge's plane n . (s, t, 1) >= 0 taken at the border of the
    // widened row where it is largest leaves a bound of s, off by less than 2^-48 size^2 / |n_x|:
    // edges are heeded where that is less than 1/64 of a tile. Edge-on triangles have no inner
    // side.
    const double step = 2.0 / tiles, guard = kLightGuard * step;
    struct Edge {
        double t, constant, slope; ///< n_y, n_w, and -1/n_x
        int side;                  ///< s is bounded from below (1), above (-1), or not (0)
    } edges[3];
    const double orientation = triangle.determinant < 0.0 ? -1.0 : 1.0;
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3 n = orientation * triangle.edges[i];
        const bool clear =
            !triangle.edgeOn && std::abs(n[x]) * step > 0x1p-42 * triangle.size * triangle.size;
        edges[i] = {n[y], sign * n[w], clear ? -1.0 / n[x] : 0.0, clear ? n[x] > 0.0 ? 1 : -1 : 0};
    }
    // 1/w is affine in the slopes: (normal . (s, t, 1)) / determinant, largest in a tile's corner.
    // Both are taken where their errors are below 2^-24 of them.
    const glm::dvec3 n = orientation * triangle.normal;
    const double depth = std::abs(triangle.determinant);
    const double area = 0x1p-22 * triangle.length * triangle.length;
    const double unclear = depth > area * triangle.size ? area : HUGE_VAL;
    const double perColumn = n[x] * step;
    for (int row = row0; row <= row1; ++row) {
        const double t0 = row * step - 1.0 - guard, t1 = (row + 1) * step - 1.0 + guard;
        double from = low[0], to = high[0];
        for (const Edge& edge : edges) {
            const double bound = (std::max(edge.t * t0, edge.t * t1) + edge.constant) * edge.slope;
            if (edge.side > 0) from = std::max(from, bound);
            if (edge.side < 0) to = std::min(to, bound);
        }
        const int begin = std::max(column0, first(toTiles(from) - 1e-6, face.column, face.columns));
        const int end = std::min(column1, last(toTiles(to) + 1e-6, face.column, face.columns));
        double inverse = std::max(n[y] * t0, n[y] * t1) + sign * n[w] +
                         n[x] * (begin * step - 1.0) +
                         std::max(-n[x] * guard, n[x] * (step + guard));
        for (int column = begin; column <= end; ++column, inverse += perColumn) {
            double near = least;
            if (inverse > unclear) near = std::max(near, depth / inverse);
            emit(tileAt(column, row), (float) (near * kBelow));
        }
    }
}

} // namespace dirt
