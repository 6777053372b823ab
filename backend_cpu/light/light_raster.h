#pragma once

#include "backend_cpu/light/light_grid.h"
#include "shaders/shared/margins.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace dirt {

// Where a ray is looked up. u = 2^-24; p = o - L is the ray's origin seen from the light, |p| <= P,
// norms are the largest component's; a place is 2^-23 of slope.
//
// The direction d is L - o rounded, so at t the ray is at (1 - t) p + t e from the light, with
// |e_i| <= u |p_i|. Where it is at w there, its slopes differ from those of p by less than
// 2 u P / w, which is P / w places. The place of p is found in float: p's components, one over the
// largest, their product and the sum with 1 are off by 3 places. An edge of a rasterized triangle
// is off by half a place at most. So what a ray meets at a depth of `near` or more lies within the
// guard of where the ray is looked up; the half place that is left covers the roundings of these
// numbers in double.

/// How many places beside a triangle's part no nearer than \p near a ray may be looked up that
/// meets it.
inline double lightGuard(double reach, double near) {
    return reach / near + kLightPlaces;
}

/// Ranges of no more nodes are listed whole, without a look at edges.
inline constexpr int kSmallLightRange = 2;

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

/// Places far beyond the rim are all one.
inline int placeAt(double place) {
    constexpr double kFar = 1 << (kPlaceBits + 2);
    return (int) std::floor(std::clamp(place, -kFar, kFar));
}
inline int placeBelow(double slope, double guard) {
    return placeAt((slope + 1.0) * kPlacesPerSlope - guard);
}
inline int placeAbove(double slope, double guard) {
    return placeAt((slope + 1.0) * kPlacesPerSlope + guard);
}

/// A box in a face, in places, both ends included.
struct PlaceBox {
    int x0, x1, y0, y1;

    /// Its part in the tile of 2^shift places from \p x, \p y on, as in LightFragment.
    uint32_t in(int x, int y, int shift) const {
        const auto byte = [&](int place) {
            return (uint32_t) (std::clamp(place, 0, (1 << shift) - 1) >> (shift - kUnitBits));
        };
        constexpr uint32_t last = (1u << kUnitBits) - 1;
        return byte(x0 - x) | (last - byte(x1 - x)) << 8 | byte(y0 - y) << 16 |
               (last - byte(y1 - y)) << 24;
    }
};

/// What cuts a large triangle's box, and its depth, to those of parts of the face.
class LightPlanes {
public:
    LightPlanes(const LightTriangle& triangle, const LightFace& face, double guard);

    /// Leaves of \p box what rows [y, y + size) of places may meet.
    void clip(int y, int size, PlaceBox& box) const;
    /// No point of the triangle within the guard of the square is nearer; or zero.
    double near(int x, int y, int size) const;

private:
    struct Edge {
        double t, constant, slope; ///< n_y, n_w, and -1/n_x
        int side;                  ///< s is bounded from below (1), above (-1), or not (0)
    } edges_[3];
    glm::dvec3 inverseDepth_; ///< times depth_: its change with s, with t, and its value at 0
    double depth_, unclear_;
    double guard_, guardSlope_;
};

/// Lists one triangle in the tiles of a face.
template <class Emit>
class LightLister {
public:
    /// Calls emit(tile, near, box) for all tiles of \p face that \p box meets, but those that the
    /// triangle's edges exclude. The triangle's part is nowhere nearer than \p least.
    LightLister(const LightGrid& grid, const LightFace& face, const Triangle& triangle,
                double guard, double least, Emit& emit)
        : grid_(grid), face_(face), triangle_(triangle), guard_(guard), least_(least), emit_(emit) {
    }

    void list(const PlaceBox& box) {
        int shift = grid_.tree.rootShift;
        // Most lie in one tile.
        const int column = (box.x0 >> shift) - face_.column, row = (box.y0 >> shift) - face_.row;
        int differ = (box.x0 ^ box.x1) | (box.y0 ^ box.y1);
        if (differ >> shift == 0) {
            if ((uint32_t) column >= (uint32_t) face_.columns ||
                (uint32_t) row >= (uint32_t) face_.rows)
                return;
            uint32_t node =
                grid_.tree.nodes[face_.firstNode + (uint32_t) (row * face_.columns + column)];
            while ((node & LightTree::kInner) != 0) {
                constexpr int split = 1 << LightTree::kSplitBits;
                const int x = box.x0 >> shift << shift, y = box.y0 >> shift << shift;
                shift -= LightTree::kSplitBits;
                const uint32_t first = node & ~LightTree::kInner;
                if (differ >> shift != 0) return listIn({first, x, y, split, split, shift}, box);
                node = grid_.tree.nodes[first + (uint32_t) (box.y0 >> shift & 3) * split +
                                        (uint32_t) (box.x0 >> shift & 3)];
            }
            const int x = box.x0 >> shift << shift, y = box.y0 >> shift << shift;
            return emit_(node, (float) (least_ * (1.0 - kLightBelow)), box.in(x, y, shift));
        }
        listIn({face_.firstNode, face_.column << shift, face_.row << shift, face_.columns,
                face_.rows, shift},
               box);
    }

private:
    /// Equal squares that stand row by row in the tree.
    struct Squares {
        uint32_t first;
        int x, y; ///< place of the first
        int columns, rows;
        int shift; ///< a square is 2^shift places wide
    };

    void listIn(const Squares& squares, PlaceBox box) {
        const int shift = squares.shift;
        const int row0 = std::max((box.y0 - squares.y) >> shift, 0);
        const int row1 = std::min((box.y1 - squares.y) >> shift, squares.rows - 1);
        const auto firstColumn = [&] { return std::max((box.x0 - squares.x) >> shift, 0); };
        const auto lastColumn = [&] {
            return std::min((box.x1 - squares.x) >> shift, squares.columns - 1);
        };
        const bool large =
            (lastColumn() - firstColumn() + 1) * (row1 - row0 + 1) > kSmallLightRange;
        if (large && !planes_)
            planes_.emplace(LightTriangle(triangle_, grid_.position), face_, guard_);
        const int x0 = box.x0, x1 = box.x1;
        for (int row = row0; row <= row1; ++row) {
            const int y = squares.y + (row << shift);
            if (large) {
                box.x0 = x0, box.x1 = x1;
                planes_->clip(y, 1 << shift, box);
            }
            const int last = lastColumn();
            for (int column = firstColumn(); column <= last; ++column) {
                const uint32_t node =
                    grid_.tree.nodes[squares.first + (uint32_t) (row * squares.columns + column)];
                const int x = squares.x + (column << shift);
                if ((node & LightTree::kInner) != 0) {
                    constexpr int split = 1 << LightTree::kSplitBits;
                    listIn({node & ~LightTree::kInner, x, y, split, split,
                            shift - LightTree::kSplitBits},
                           box);
                    continue;
                }
                const double near =
                    planes_ ? std::max(least_, planes_->near(x, y, 1 << shift)) : least_;
                emit_(node, (float) (near * (1.0 - kLightBelow)), box.in(x, y, shift));
            }
        }
    }

    const LightGrid& grid_;
    const LightFace& face_;
    const Triangle& triangle_;
    const double guard_, least_;
    Emit& emit_;
    std::optional<LightPlanes> planes_;
};

/// Calls emit(tile, near, box) for at least all tiles of \p face that come within the guard of a
/// part of the triangle with w >= \p clip. No point of that part within the guard of the tile is
/// nearer than `near`, or more than the guard outside the box.
template <class Emit>
void rasterFromLight(const LightGrid& grid, const Triangle& triangle, const LightFace& face,
                     double clip, Emit&& emit) {
    const LightTriangle seen(triangle, grid.position);
    const int x = face.axisX, y = face.axisY, w = face.axisW;
    const double sign = face.signW, rim = 1.0 + kLightRim;
    const glm::dvec3* const v = seen.v;
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
    const double guard = lightGuard(grid.reach, least);
    LightLister lister(grid, face, triangle, guard, least, emit);
    lister.list({placeBelow(low[0], guard), placeAbove(high[0], guard), placeBelow(low[1], guard),
                 placeAbove(high[1], guard)});
}

/// The fragments of triangles [begin, end) in \p grid, whose tree is made; writes the records of
/// those that have any. Three vertices well inside a face are looked at in SIMD.
void scanFromLight(const FrameGeometry& geometry, LightGrid& grid, size_t begin, size_t end,
                   LightPiece& piece);

} // namespace dirt
