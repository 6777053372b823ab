// The walk of one ray through the tiles of one view. Included once for each instruction set.

#if defined(DIRT_TILE_WALK_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef DIRT_TILE_WALK_INL_H_
#undef DIRT_TILE_WALK_INL_H_
#else
#define DIRT_TILE_WALK_INL_H_
#endif

#include "backend_cpu/tracer.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace dirt::HWY_NAMESPACE {

inline constexpr double kForever = std::numeric_limits<double>::infinity();

/// The part of a ray in one view, and its numbers in the view's frame.
///
/// Crossings are those of core's ViewRay: t = N / D and w = m / D, here through one reciprocal,
/// with relative errors below 2^-50. What core decides at corners by the side of the line, this
/// walk leaves to the guard band. At a border s that is crossed at t_s, the ray at t has
/// |x - s w| = |D (t - t_s)|; between t_s and its computed value that is at most 2^-50 |N| <=
/// 2^-49 S |o|, S the slope at the rim. So a point of the ray lies in the tile it is visited in
/// but for 2^-49 S |o| / w. Where the ray keeps w >= 2^-26 |o|, that is 2^-23 S, and less than
/// 1/1024 of a tile, which is 2^-22 S at 8192 tiles: within the 1/512 that tiles list. Its depth is
/// likewise off by 2^-50 (|o| + w) <= 2^-23 w. Rays that come nearer to the eye are not walked.
struct ViewPart {
    double ox, oy, ow, dx, dy, dw;
    double begin, end; ///< rounded outwards
    double depth;      ///< w at begin

    /// Cuts the part to where a + b t >= 0.
    bool cut(double a, double b) {
        if (b == 0.0) return a >= 0.0;
        if (a < 0.0 && b < 0.0) return false;
        const double t = -a / b;
        if (b > 0.0)
            begin = std::max(begin, t * (1.0 - 0x1p-49));
        else
            end = std::min(end, t * (1.0 + 0x1p-49));
        return begin <= end;
    }

    /// False if the ray is not in the view's closed cone.
    bool set(const TracedView& view, const Ray& ray) {
        ox = ray.origin[view.axisX], dx = ray.direction[view.axisX];
        oy = ray.origin[view.axisY], dy = ray.direction[view.axisY];
        ow = view.signW * ray.origin[view.axisW], dw = view.signW * ray.direction[view.axisW];
        if (ow < 0.0 && dw <= 0.0) return false;
        begin = 0.0, end = kForever;
        const double s0 = view.s[0], s1 = view.s[view.columns];
        const double t0 = view.t[0], t1 = view.t[view.rows];
        if (!(cut(ox - s0 * ow, dx - s0 * dw) && cut(s1 * ow - ox, s1 * dw - dx) &&
              cut(oy - t0 * ow, dy - t0 * dw) && cut(t1 * ow - oy, t1 * dw - dy)))
            return false;
        depth = ow + begin * dw;
        return true;
    }

    /// Whether the bounds above hold: the ray stays clear of the eye, or starts there.
    bool clearOfEye() const {
        const double away = std::max({std::abs(ox), std::abs(oy), std::abs(ow)});
        const double last = end == kForever ? (dw < 0.0 ? 0.0 : depth) : ow + end * dw;
        return std::min(depth, last) >= 0x1p-26 * away;
    }
};

/// A tile that the ray visits: parameters rounded outwards, depths of the ray in it.
struct Visit {
    double begin, end;
    float near, far;
    int tile;
};

/// Calls \p visit(Visit) for the tiles of the view whose depth bounds meet the ray's depths in
/// them, in the order of t, until one begins after \p limit.
template <class Function>
HWY_INLINE void walkTiles(const TracedView& view, const ViewPart& part, const double& limit,
                          uint64_t& steps, Function&& visit) {
    const double my = part.ow * part.dx - part.ox * part.dw;
    const double mx = part.ow * part.dy - part.oy * part.dw;
    const int stepX = (my > 0.0) - (my < 0.0), stepY = (mx > 0.0) - (mx < 0.0);

    // The slopes at the begin; of a ray from the eye, those of its direction.
    double x = part.ox + part.begin * part.dx, y = part.oy + part.begin * part.dy;
    double w = part.depth;
    if (!(w > 0.0)) x = part.dx, y = part.dy, w = part.dw;
    if (!(w > 0.0)) return; // in the eye alone
    const double inverse = 1.0 / w;
    int column = (int) ((x * inverse - view.s[0]) * view.tilesPerX);
    int row = (int) ((y * inverse - view.t[0]) * view.tilesPerY);
    column = std::clamp(column, 0, view.columns - 1);
    row = std::clamp(row, 0, view.rows - 1);

    // Where the border ahead is crossed; never, if that would be behind the eye.
    struct Crossing {
        double t, depth;
    };
    const auto crossing = [](double slope, double o, double d, double ow, double dw, double m) {
        const double denominator = d - slope * dw;
        if (!(denominator * m > 0.0)) return Crossing{kForever, 0.0};
        const double r = 1.0 / denominator;
        return Crossing{(slope * ow - o) * r, m * r};
    };
    const float* s = view.s + (stepX > 0 ? 1 : 0);
    const float* t = view.t + (stepY > 0 ? 1 : 0);
    Crossing nextX{kForever, 0.0}, nextY{kForever, 0.0};
    if (stepX != 0) nextX = crossing(s[column], part.ox, part.dx, part.ow, part.dw, my);
    if (stepY != 0) nextY = crossing(t[row], part.oy, part.dy, part.ow, part.dw, mx);

    const double depthAtEnd = part.end == kForever ? (part.dw > 0.0 ? kForever : part.depth)
                                                   : part.ow + part.end * part.dw;
    double begin = part.begin, depth = part.depth;
    while (begin <= limit) {
        ++steps;
        const bool throughX = nextX.t < nextY.t;
        double end = throughX ? nextX.t : nextY.t;
        double exitDepth = throughX ? nextX.depth : nextY.depth;
        const bool last = !(end < part.end);
        if (last) end = part.end, exitDepth = depthAtEnd;

        const int tile = row * view.columns + column;
        const TileDepths& bounds = view.tiles[tile];
        const float near = (float) (std::min(depth, exitDepth) * (1.0 - 0x1p-21));
        const float far = (float) std::min(std::max(depth, exitDepth) * (1.0 + 0x1p-21), 0x1p100);
        if (bounds.near <= far && near <= bounds.far)
            visit(Visit{begin, end * (1.0 + 0x1p-48), near, far, tile});
        if (last) return;

        begin = std::max(begin, end * (1.0 - 0x1p-48));
        depth = exitDepth;
        if (throughX) {
            column += stepX;
            if ((unsigned) column >= (unsigned) view.columns) return;
            nextX = crossing(s[column], part.ox, part.dx, part.ow, part.dw, my);
        } else {
            row += stepY;
            if ((unsigned) row >= (unsigned) view.rows) return;
            nextY = crossing(t[row], part.oy, part.dy, part.ow, part.dw, mx);
        }
    }
}

} // namespace dirt::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
