#pragma once

#include "core/grid/grid.h"
#include "core/trace/view_ray.h"
#include "shaders/shared/rounding.h"

#include <algorithm>
#include <cmath>

namespace dirt {

/// A tile that a ray visits: parameters and depths, rounded outwards.
struct TileVisit {
    int view = 0, tile = 0;
    double begin = 0.0, end = 0.0;
    float near = 0.0f, far = 0.0f; ///< depths of the ray inside the tile
};

/// A cell of a view's depth pyramid that a ray looks at.
struct CellLook {
    int view = 0, level = 0, column = 0, row = 0;
    double begin = 0.0;           ///< where the ray enters the tile in which it comes in
    double near = 0.0, far = 0.0; ///< depths of the ray inside the cell
    DepthBounds bounds;           ///< of what the cell lists
    bool passedOver = false;      ///< the depths do not meet
};

/// Walks a ray through the tiles of one view, up and down the depth pyramid (T1).
///
/// The walk keeps the tile (column, row) it is in; which border comes next is decided by the side
/// on which the tile's corner lies of the ray's image. Where a row (or column) has to be found
/// anew, at the view's rim or after a step over a larger cell, the earliest that the ray may be in
/// is taken: being behind costs a visit, being ahead would lose one.
///
/// Where rounding leaves open which border comes first, the walk goes on in the tile beyond the
/// corner. The neighbour that the ray may pass between its crossings A and B of the two borders
/// needs no visit. With V = m . (s, t, 1) at the corner C, the bound in order() gives
/// |V| < 2^-49 (|m_x s| + |m_y t|), so the image passes C at a distance d < 2^-48 S, S the length
/// of the view's greatest slopes; guard bands are wider than 2^-22 S (1/512 of a tile, 8192 tiles).
/// Between A and B the image is the hypotenuse of a right triangle with C at the right angle, whose
/// other sides lie on the borders. The foot F of the altitude on C divides it: what lies between A
/// and F is within |CF| = d of CA, a side of the tile that is left, and what lies between F and B
/// within d of CB, a side of the tile that is entered or, where CB is longer, of those that follow
/// it along the border, each visited from where the ray enters its row or column. The tiles before
/// and beyond C are visited with the parameters and depths from A to B. The same holds of a cell
/// that is stepped over, whose bounds hold all that its tiles list.
///
/// At the view's rim there is no tile beyond: the walk goes along the rim until it is certain that
/// the ray has crossed it, which a ray close to the eye may do many tiles later.
class ViewWalk {
public:
    /// Starts at the begin of \p span. Not valid if the ray touches the cone in the eye alone.
    ViewWalk(const ViewRay& ray, const ViewSpan& span, const DepthPyramid& pyramid, int topLevel);
    bool valid() const { return column_ >= 0 && row_ >= 0; }

    /// Calls \p visit(TileVisit) for every tile whose depth bounds meet the ray's depths in it, in
    /// the order of t, until the view is left or a tile begins after \p limit, which visit may
    /// lower. Calls \p look(CellLook) for every cell of the pyramid before that.
    template <class Look, class Visit>
    void run(const double& limit, Look&& look, Visit&& visit);

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

template <class Look, class Visit>
void ViewWalk::run(const double& limit, Look&& look, Visit&& visit) {
    const auto offer = [&](double end, double near, double far) {
        const DepthBounds& bounds = pyramid_.levels[0].at(column_, row_);
        const float lo = roundDown(near * (1.0 - kDepthSlack));
        const float hi = roundUp(far * (1.0 + kDepthSlack));
        if (bounds.far < lo || bounds.near > hi) return;
        visit(TileVisit{view_, row_ * pyramid_.levels[0].columns + column_, begin_, end, lo, hi});
    };

    int level = top_;
    while (begin_ <= limit) {
        const Exit exit = exitOf(level);
        const double near = std::min(depth_, exit.near), far = std::max(depth_, exit.far);
        const DepthBounds& bounds = pyramid_.levels[level].at(column_ >> level, row_ >> level);
        const bool empty =
            bounds.far < near * (1.0 - kDepthSlack) || bounds.near > far * (1.0 + kDepthSlack);
        look(CellLook{view_, level, column_ >> level, row_ >> level, begin_, near, far, bounds,
                      empty});
        if (!empty && level > 0) {
            --level;
            continue;
        }
        if (!empty) offer(exit.end * (1.0 + kCrossingSlack), near, far);
        if (exit.order == 2 || !advance(exit, level)) return;
        // Up again where a border of the next coarser level was crossed.
        const int mask = (2 << level) - 1;
        const bool coarser = (exit.order >= 0 && (exit.columnBorder & mask) == 0) ||
                             (exit.order <= 0 && (exit.rowBorder & mask) == 0);
        if (coarser && level < top_) ++level;
    }
}

} // namespace dirt
