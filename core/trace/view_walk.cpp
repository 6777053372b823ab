#include "core/trace/view_walk.h"

namespace dirt {
ViewWalk::ViewWalk(const ViewRay& ray, const ViewSpan& span, const DepthPyramid& pyramid,
                   int topLevel)
    : ray_(ray), pyramid_(pyramid), view_(span.view),
      top_(std::min(topLevel, (int) pyramid.levels.size() - 1)),
      column_(startCell(0, ray.view.s, span.begin)), row_(startCell(1, ray.view.t, span.begin)),
      begin_(span.begin), end_(span.end), depth_(std::max(span.depth, 0.0)) {}

int ViewWalk::startCell(int axis, const std::vector<float>& borders, double t) const {
    const int step = ray_.step[axis];
    const int last = (int) borders.size() - 2;
    if (step != 0)
        return step > 0 ? firstNotLeft(axis, 0, last, t) : firstNotLeft(axis, last, 0, t);

    // The slope does not change along the ray: that of any of its points before the eye, or of its
    // direction. Comparisons of float products are exact.
    const glm::dvec3& p = ray_.origin.z > 0.0 ? ray_.origin : ray_.direction;
    const bool inside =
        p.z > 0.0 && p[axis] >= borders.front() * p.z && p[axis] <= borders.back() * p.z;
    if (!inside) return -1; // the ray meets the cone in the eye alone
    const auto above = std::partition_point(borders.begin(), borders.end(),
                                            [&](float s) { return s * p.z <= p[axis]; });
    return std::clamp((int) (above - borders.begin()) - 1, 0, last);
}

int ViewWalk::firstNotLeft(int axis, int from, int to, double t) const {
    const int step = ray_.step[axis];
    const double earliest = t * (1.0 - kCrossingSlack);
    int low = 0, high = std::abs(to - from); // the answer is in [low, high]
    while (low < high) {
        const int middle = (low + high) / 2;
        const int border = from + middle * step + (step > 0 ? 1 : 0);
        if (crossingOf(ray_, axis, (axis == 0 ? ray_.view.s : ray_.view.t)[border]).t < earliest)
            low = middle + 1;
        else
            high = middle;
    }
    return from + low * step;
}

ViewWalk::Exit ViewWalk::exitOf(int level) const {
    const DepthPyramid::Level& tiles = pyramid_.levels[0];
    Exit exit{};
    const int column = column_ >> level << level, row = row_ >> level << level;
    exit.columnBorder = ray_.step.x > 0 ? std::min(column + (1 << level), tiles.columns) : column;
    exit.rowBorder = ray_.step.y > 0 ? std::min(row + (1 << level), tiles.rows) : row;
    const float s = ray_.view.s[exit.columnBorder], t = ray_.view.t[exit.rowBorder];

    const Crossing x = ray_.step.x != 0 ? crossingOf(ray_, 0, s) : Crossing{};
    const Crossing y = ray_.step.y != 0 ? crossingOf(ray_, 1, t) : Crossing{};
    exit.order = x.valid && y.valid ? orderOf(ray_, s, t) : x.valid ? 1 : y.valid ? -1 : 2;
    if (exit.order == 0) { // along the rim, if only one border is one
        const bool columnRim = exit.columnBorder == 0 || exit.columnBorder == tiles.columns;
        const bool rowRim = exit.rowBorder == 0 || exit.rowBorder == tiles.rows;
        exit.order = (int) rowRim - (int) columnRim;
    }
    switch (exit.order) {
    case 1:
        exit.begin = exit.end = x.t, exit.near = exit.far = x.depth;
        break;
    case -1:
        exit.begin = exit.end = y.t, exit.near = exit.far = y.depth;
        break;
    case 0:
        exit.begin = std::min(x.t, y.t), exit.end = std::max(x.t, y.t);
        exit.near = std::min(x.depth, y.depth), exit.far = std::max(x.depth, y.depth);
        break;
    default: // The ray stays in this cell: for ever, or until it reaches the eye.
        exit.begin = exit.end = end_;
        exit.near = exit.far = ray_.direction.z > 0.0   ? infinity()
                               : ray_.direction.z < 0.0 ? 0.0
                                                        : ray_.origin.z;
    }
    return exit;
}

/// Moves into the next tile. False if that leaves the view.
bool ViewWalk::advance(const Exit& exit, int level) {
    const DepthPyramid::Level& tiles = pyramid_.levels[0];
    const int column = column_ >> level << level, row = row_ >> level << level;
    if (exit.order >= 0)
        column_ = ray_.step.x > 0 ? exit.columnBorder : exit.columnBorder - 1;
    else if (level > 0 && ray_.step.x != 0)
        column_ = firstNotLeft(0, column_,
                               ray_.step.x > 0 ? std::min(column + (1 << level), tiles.columns) - 1
                                               : column,
                               exit.begin);
    if (exit.order <= 0)
        row_ = ray_.step.y > 0 ? exit.rowBorder : exit.rowBorder - 1;
    else if (level > 0 && ray_.step.y != 0)
        row_ = firstNotLeft(1, row_,
                            ray_.step.y > 0 ? std::min(row + (1 << level), tiles.rows) - 1 : row,
                            exit.begin);
    begin_ = std::max(begin_, exit.begin * (1.0 - kCrossingSlack));
    // At a corner the earlier depth is the one farther back along the ray.
    depth_ = ray_.direction.z > 0.0 ? exit.near : exit.far;
    return column_ >= 0 && row_ >= 0 && column_ < tiles.columns && row_ < tiles.rows;
}

} // namespace dirt
