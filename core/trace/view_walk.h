#pragma once

#include "core/grid/grid.h"
#include "core/grid/rounding.h"
#include "core/trace/view_ray.h"

#include <algorithm>
#include <cmath>

namespace dirt {

/// A tile that a ray visits: parameters and depths, rounded outwards.
struct TileVisit {
    int view = 0, tile = 0;
    double begin = 0.0, end = 0.0;
    float near = 0.0f, far = 0.0f; ///< depths of the ray inside the tile
};

/// Walks a ray through the tiles of one view, up and down the depth pyramid (T1).
///
/// The walk keeps the tile (column, row) it is in; which border comes next is decided by the side
/// on which the tile's corner lies of the ray's image. Where rounding leaves that open, both
/// neighbours at the corner are visited. Where a row (or column) has to be found anew, at the
/// view's rim or after a step over a larger cell, the earliest that the ray may be in is taken:
/// being behind costs a visit, being ahead would lose one.
class ViewWalk {
public:
    /// Starts at the begin of \p span. Not valid if the ray touches the cone in the eye alone.
    ViewWalk(const ViewRay& ray, const ViewSpan& span, const DepthPyramid& pyramid, int topLevel);
    bool valid() const { return column_ >= 0 && row_ >= 0; }

    /// Calls \p visit(TileVisit) for every tile whose depth bounds meet the ray's depths in it, in
    /// the order of t, until the view is left or a tile begins after \p limit, which visit may
    /// lower. Adds the cells looked at to \p steps.
    template <class Visit>
    void run(const double& limit, uint64_t& steps, Visit&& visit);

private:
    /// How the ray leaves a cell.
    struct Exit {
        int order; ///< 1: through the column border, -1: the row border, 0: their corner, 2: never
        int columnBorder, rowBorder;
        double begin, end; ///< of the crossing (two at a corner)
        double near, far;  ///< depths there
    };
    Exit exitOf(int level) const;
    bool advance(const Exit& exit, int level);

    /// First cell in [from, to], in the order of the ray, that is not left before t.
    int firstNotLeft(int axis, int from, int to, double t) const;
    int startCell(int axis, const std::vector<float>& borders, double t) const;

    const ViewRay& ray_;
    const DepthPyramid& pyramid_;
    int view_, top_;
    int column_, row_;
    double begin_; ///< where the current tile is entered,
    double end_;   ///< where the view is left,
    double depth_; ///< and w at begin_
};

template <class Visit>
void ViewWalk::run(const double& limit, uint64_t& steps, Visit&& visit) {
    // Depths are exact to 2^-51; twice that at the ends, with room.
    constexpr double kSlack = 0x1p-48;
    const auto offer = [&](int column, int row, double begin, double end, double near, double far) {
        const DepthPyramid::Level& tiles = pyramid_.levels[0];
        if (column < 0 || row < 0 || column >= tiles.columns || row >= tiles.rows) return;
        const DepthBounds& bounds = tiles.at(column, row);
        const float lo = roundDown(near * (1.0 - kSlack)), hi = roundUp(far * (1.0 + kSlack));
        if (bounds.far < lo || bounds.near > hi) return;
        visit(TileVisit{view_, row * tiles.columns + column, begin, end, lo, hi});
    };

    int level = top_;
    while (begin_ <= limit) {
        ++steps;
        const Exit exit = exitOf(level);
        const double near = std::min(depth_, exit.near), far = std::max(depth_, exit.far);
        const DepthBounds& bounds = pyramid_.levels[level].at(column_ >> level, row_ >> level);
        const bool empty = bounds.far < near * (1.0 - kSlack) || bounds.near > far * (1.0 + kSlack);
        if (!empty && level > 0) {
            --level;
            continue;
        }
        if (!empty) offer(column_, row_, begin_, exit.end * (1.0 + kCrossingSlack), near, far);
        if (exit.order == 2) return;
        if (exit.order == 0) {
            const double begin = exit.begin * (1.0 - kCrossingSlack);
            const double end = exit.end * (1.0 + kCrossingSlack);
            const int lastColumn = ray_.stepX > 0 ? exit.columnBorder - 1 : exit.columnBorder;
            const int lastRow = ray_.stepY > 0 ? exit.rowBorder - 1 : exit.rowBorder;
            offer(lastColumn + ray_.stepX, lastRow, begin, end, exit.near, exit.far);
            offer(lastColumn, lastRow + ray_.stepY, begin, end, exit.near, exit.far);
        }
        if (!advance(exit, level)) return;
        // Up again where a border of the next coarser level was crossed.
        const int mask = (2 << level) - 1;
        const bool coarser = (exit.order >= 0 && (exit.columnBorder & mask) == 0) ||
                             (exit.order <= 0 && (exit.rowBorder & mask) == 0);
        if (coarser && level < top_) ++level;
    }
}

} // namespace dirt
