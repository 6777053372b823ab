#pragma once

#include "core/grid/coverage.h"
#include "core/verify/exact_number.h"

#include <array>
#include <vector>

/// The exact clip of a triangle to the cone of a tile: what G1 and G2 are stated in.
namespace dirt {

/// Width of a tile in slopes along x and y: that of all columns (rows) but the last one, which may
/// be partial.
struct TileSize {
    double x, y;
};
inline TileSize tileSize(const View& view, int tilePixels) {
    return {((double) view.s.back() - view.s.front()) * tilePixels / view.width,
            ((double) view.t.back() - view.t.front()) * tilePixels / view.height};
}

/// The column (or row) whose borders enclose \p slope, or the nearest one.
inline int cellAt(const std::vector<float>& borders, double slope) {
    int lo = 0, hi = (int) borders.size() - 2;
    while (lo < hi) {
        const int middle = (lo + hi + 1) / 2;
        if (borders[middle] <= slope)
            lo = middle;
        else
            hi = middle - 1;
    }
    return lo;
}

/// The closed cone of a tile, widened by a fraction of a tile: its border slopes times 2^fraction.
struct ExactCone {
    static constexpr int kMargin = 60; ///< fractional bits to which the margin is rounded

    std::array<Integer, 2> x, y;
    int fraction = kMargin;

    ExactCone(const View& view, int column, int row, TileSize tile, double widened)
        : ExactCone(view, {column, column, row, row}, tile, widened) {}

    /// Of a block of tiles.
    ExactCone(const View& view, TileRange range, TileSize tile, double widened) {
        const float s0 = view.s[range.column0], s1 = view.s[range.column1 + 1];
        const float t0 = view.t[range.row0], t1 = view.t[range.row1 + 1];
        for (float border : {s0, s1, t0, t1})
            if (border != 0.0f) fraction = std::max(fraction, -lowestExponent(border));
        const Integer dx = margin(tile.x * widened), dy = margin(tile.y * widened);
        x = {toInteger(s0, -fraction) - dx, toInteger(s1, -fraction) + dx};
        y = {toInteger(t0, -fraction) - dy, toInteger(t1, -fraction) + dy};
    }

    /// Signed distances to the four side planes, up to a positive factor; inside where none is
    /// negative (which implies w >= 0).
    std::array<Integer, 4> distances(const IntegerVector& p) const {
        const Integer px = p.x << fraction, py = p.y << fraction;
        return {px - x[0] * p.z, x[1] * p.z - px, py - y[0] * p.z, y[1] * p.z - py};
    }

    bool contains(const IntegerVector& p) const {
        for (const Integer& d : distances(p))
            if (d < 0) return false;
        return p.z > 0;
    }

private:
    Integer margin(double slope) const {
        // Of 4 and more a double has no bits below 2^-kMargin.
        const Integer scaled = slope < 4.0
                                   ? Integer((int64_t) std::llround(std::ldexp(slope, kMargin)))
                                   : toInteger(slope, -kMargin);
        return scaled << (fraction - kMargin);
    }
};

/// A triangle in the frame of a view, as integers times 2^exponent.
struct ExactTriangle {
    std::array<IntegerVector, 3> vertices;
    std::array<IntegerVector, 3>
        edges;             ///< normals of the planes through the eye: a x b, b x c, c x a
    Integer volume;        ///< a . (b x c)
    bool holdsEye = false; ///< the eye is a point of the closed triangle
    int exponent;

    ExactTriangle(const Triangle& triangle, const View& view) {
        const glm::vec3 p[3] = {view.toView(triangle.a), view.toView(triangle.b),
                                view.toView(triangle.c)};
        exponent = std::min({lowestExponent(p[0]), lowestExponent(p[1]), lowestExponent(p[2])});
        if (exponent == INT_MAX) exponent = 0;
        for (int i = 0; i < 3; ++i) vertices[i] = toIntegers(p[i], exponent);
        for (int i = 0; i < 3; ++i) edges[i] = cross(vertices[i], vertices[(i + 1) % 3]);
        volume = dot(vertices[2], edges[0]);
        holdsEye = computeHoldsEye();
    }

private:
    bool computeHoldsEye() const {
        bool onEdge = false;
        for (int i = 0; i < 3; ++i) {
            if (vertices[i].isZero()) return true;
            if (edges[i].isZero()) onEdge |= dot(vertices[i], vertices[(i + 1) % 3]) < 0;
        }
        if (onEdge || volume != 0) return onEdge;
        const IntegerVector normal = edges[0] + edges[1] + edges[2];
        if (normal.isZero()) return false;
        for (const IntegerVector& edge : edges)
            if (dot(edge, normal) < 0) return false;
        return true;
    }
};

/// The depths of the points, w > 0, that a triangle and a cone share; near is zero, and then not
/// itself such a depth, where the triangle holds the eye.
struct ExactDepths {
    bool meets = false;
    Fraction near, far;
};

/// The extreme points of triangle and closed cone together are among: the triangle's vertices
/// inside the cone, its edges' crossings with the side planes, the cone's corner rays' crossings
/// with the triangle, and the eye. This holds for segments, points and edge-on triangles too. So
/// no polygon is clipped, and no number grows beyond the product of a few inputs.
inline ExactDepths clipExactly(const ExactTriangle& triangle, const ExactCone& cone) {
    ExactDepths depths;
    auto include = [&](Integer numerator, Integer denominator) {
        if (numerator == 0) return; // the eye
        const Fraction depth{std::move(numerator), std::move(denominator), triangle.exponent};
        if (!depths.meets || compare(depth, depths.near) < 0) depths.near = depth;
        if (!depths.meets || compare(depth, depths.far) > 0) depths.far = depth;
        depths.meets = true;
    };

    std::array<std::array<Integer, 4>, 3> distances;
    for (int i = 0; i < 3; ++i) {
        distances[i] = cone.distances(triangle.vertices[i]);
        if (std::all_of(distances[i].begin(), distances[i].end(),
                        [](const Integer& d) { return d >= 0; }))
            include(triangle.vertices[i].z, 1);
    }
    for (int plane = 0; plane < 4; ++plane) // all vertices outside one plane: nothing
        if (distances[0][plane] < 0 && distances[1][plane] < 0 && distances[2][plane] < 0)
            return depths;

    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        for (int plane = 0; plane < 4; ++plane) {
            const Integer &di = distances[i][plane], &dj = distances[j][plane];
            if (sign(di) * sign(dj) >= 0) continue;
            const Integer weightI = abs(dj), weightJ = abs(di);
            bool inside = true;
            for (int other = 0; other < 4 && inside; ++other)
                inside = other == plane ||
                         distances[i][other] * weightI + distances[j][other] * weightJ >= 0;
            if (inside)
                include(triangle.vertices[i].z * weightI + triangle.vertices[j].z * weightJ,
                        weightI + weightJ);
        }
    }

    if (triangle.volume != 0) {
        const Integer one = Integer(1) << cone.fraction;
        for (int corner = 0; corner < 4; ++corner) {
            const IntegerVector ray{cone.x[corner & 1], cone.y[corner >> 1], one};
            Integer sides[3], sum = 0;
            for (int i = 0; i < 3; ++i) sum += sides[i] = dot(triangle.edges[i], ray);
            if (sign(sum) * sign(triangle.volume) <= 0) continue; // parallel, or behind the eye
            if (sign(sides[0]) * sign(sum) < 0 || sign(sides[1]) * sign(sum) < 0 ||
                sign(sides[2]) * sign(sum) < 0)
                continue;
            include(abs(triangle.volume) * one, abs(sum));
        }
    }

    if (triangle.holdsEye && depths.meets) depths.near = Fraction{0, 1, triangle.exponent};
    return depths;
}

} // namespace dirt
