// The walk of one ray through the tiles of one view. Included once for each instruction set.

#if defined(DIRT_TILE_WALK_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef DIRT_TILE_WALK_INL_H_
#undef DIRT_TILE_WALK_INL_H_
#else
#define DIRT_TILE_WALK_INL_H_
#endif

#include "backend_cpu/trace/tracer.h"
#include "shaders/shared/margins.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace dirt::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

inline constexpr double kForever = std::numeric_limits<double>::infinity();

/// The part of a ray in one view, and its numbers in the view's frame.
///
/// Crossings are those of core's ViewRay: t = N / D and w = m / D, here through one reciprocal,
/// with relative errors of 4 * 2^-53. What core decides at corners by the side of the line, this
/// walk leaves to the guard band. At a border s that is crossed at t_s, the ray at t has
/// |x - s w| = |D (t - t_s)|; between t_s and its computed value that is at most 2^-51 |N| <=
/// 2^-51 (1 + S) |o|, S the slope at the rim. So a point of the ray lies in the tile it is visited
/// in but for a slope of 2^-50 max(1, S) |o| / w. Where the ray keeps w >= 2^-26 max(1, 1/S) |o|,
/// that is 2^-24 S, and less than 1/4096 of a tile, which is 2^-24 S at 8192 tiles: within the
/// 1/512 that tiles list. Its depth is likewise off by 2^-51 (|o| + w), by that of a crossing, or
/// 2^-52 (|o| + w) at the view's rim, and less than 2^-24 w in all. Rays that come nearer to the
/// eye are not walked.
struct ViewPart {
    double o[2], d[2], ow, dw; ///< x and y; w
    double begin, end;         ///< rounded outwards
    double depth;              ///< w at begin
    int view;
};

/// The parts of a ray in all views, in the order in which it enters them.
struct ViewParts {
    std::array<ViewPart, kMaxViews> part;
    int count = 0;

    /// False if the ray comes too near to the eye to be walked.
    bool set(const ViewTable& views, const Ray& ray) {
        constexpr int kLanes = ViewTable::kLanes;
        HWY_ALIGN double o[3][kLanes], d[3][kLanes], begins[kLanes], ends[kLanes], depths[kLanes];
        for (int lane = 0; lane < kLanes; ++lane)
            for (int i = 0; i < 3; ++i) {
                o[i][lane] = views.sign[i][lane] * ray.origin[views.axis[i][lane]];
                d[i][lane] = views.sign[i][lane] * ray.direction[views.axis[i][lane]];
            }
        const double away =
            std::max({std::abs(ray.origin.x), std::abs(ray.origin.y), std::abs(ray.origin.z)});

        const hn::CappedTag<double, kLanes> tag;
        using V = hn::Vec<decltype(tag)>;
        uint32_t alive = 0, close = 0;
        for (size_t lane = 0; lane < kLanes; lane += hn::Lanes(tag)) {
            const V zero = hn::Zero(tag), forever = hn::Set(tag, kForever);
            const V ow = hn::Load(tag, o[2] + lane), dw = hn::Load(tag, d[2] + lane);
            V begin = zero, end = forever;
            for (int axis = 0; axis < 2; ++axis) {
                const V x = hn::Load(tag, o[axis] + lane), dx = hn::Load(tag, d[axis] + lane);
                for (int side = 0; side < 2; ++side) {
                    // The view is where a + b t >= 0.
                    const V slope = hn::Load(tag, views.rim[axis][side] + lane);
                    V a = hn::Sub(x, hn::Mul(slope, ow)), b = hn::Sub(dx, hn::Mul(slope, dw));
                    if (side == 1) a = hn::Neg(a), b = hn::Neg(b);
                    const V t = hn::Neg(hn::Div(a, b));
                    const auto enters = hn::Gt(b, zero), leaves = hn::Lt(b, zero);
                    const auto outside = hn::And(hn::Eq(b, zero), hn::Lt(a, zero));
                    const V early = hn::Mul(t, hn::Set(tag, 1.0 - kVisitSlack));
                    const V late = hn::Mul(t, hn::Set(tag, 1.0 + kVisitSlack));
                    begin = hn::IfThenElse(enters, hn::Max(begin, early), begin);
                    end = hn::IfThenElse(leaves, hn::Min(end, late), end);
                    end = hn::IfThenElse(outside, hn::Set(tag, -1.0), end);
                }
            }
            const V depth = hn::Add(ow, hn::Mul(begin, dw));
            const V last = hn::Add(ow, hn::Mul(hn::Min(end, hn::Set(tag, 0x1p100)), dw));
            hn::Store(begin, tag, begins + lane);
            hn::Store(end, tag, ends + lane);
            hn::Store(depth, tag, depths + lane);
            // A cone is left at once where the next one is entered, unless there is none.
            const auto met =
                hn::And(hn::Le(begin, end), hn::Gt(end, hn::Load(tag, views.atLeast + lane)));
            const auto near =
                hn::Lt(hn::Min(depth, last),
                       hn::Mul(hn::Load(tag, views.nearest + lane), hn::Set(tag, away)));
            alive |= maskBits(tag, met) << lane;
            close |= maskBits(tag, near) << lane;
        }
        if ((alive & close) != 0) return false;
        for (; alive != 0; alive &= alive - 1) {
            const int v = (int) hwy::Num0BitsBelowLS1Bit_Nonzero32(alive);
            int i = count++;
            for (; i > 0 && begins[v] < part[i - 1].begin; --i) part[i] = part[i - 1];
            part[i] = {{o[0][v], o[1][v]},
                       {d[0][v], d[1][v]},
                       o[2][v],
                       d[2][v],
                       begins[v],
                       ends[v],
                       depths[v],
                       v};
        }
        return true;
    }

private:
    template <class Tag, class Mask>
    static HWY_INLINE uint32_t maskBits(Tag tag, Mask mask) {
        uint8_t bits[8] = {};
        hn::StoreMaskBits(tag, mask, bits);
        return bits[0];
    }
};

/// A tile that the ray visits: parameters rounded outwards, depths of the ray in it.
struct Visit {
    double begin, end;
    float near, far;
    int tile;
};

/// Calls \p visit(Visit) for the tiles of the view that hold anything at the ray's depths in them,
/// in the order of t, until one begins after \p limit.
template <class Function>
HWY_INLINE void walkTiles(const TracedView& view, const ViewPart& part, const double& limit,
                          uint64_t& steps, Function&& visit) {
    // The slopes at the begin; of a ray from the eye, those of its direction.
    const bool fromEye = !(part.depth > 0.0);
    const double w = fromEye ? part.dw : part.depth;
    if (!(w > 0.0)) return; // in the eye alone
    const double inverse = 1.0 / w;

    // Along one axis: the tile, and where its border ahead is crossed; never, if that would be
    // behind the eye.
    struct Axis {
        double o, d, growth; ///< growth of x/w along the ray, exact in sign
        const float* border;
        int left; ///< tiles before the rim
        int tileStep, borderStep;
        double t, depth;
    };
    const auto cross = [&part](Axis& axis) HWY_ATTR {
        const double slope = *axis.border;
        const double denominator = axis.d - slope * part.dw;
        const double r = 1.0 / denominator;
        axis.t = denominator * axis.growth > 0.0 ? (slope * part.ow - axis.o) * r : kForever;
        axis.depth = axis.growth * r;
    };
    int tile = 0;
    const auto start = [&](int i) HWY_ATTR {
        Axis axis;
        axis.o = part.o[i], axis.d = part.d[i];
        axis.growth = part.ow * axis.d - axis.o * part.dw;
        const double x = fromEye ? axis.d : axis.o + part.begin * axis.d;
        const int at =
            std::clamp((int) ((x * inverse - view.borders[i][0]) * view.tilesPerSlope[i]), 0,
                       view.tiles[i] - 1);
        const bool up = axis.growth > 0.0;
        const int stride = i == 0 ? 1 : view.tiles[0];
        tile += at * stride;
        axis.left = up ? view.tiles[i] - 1 - at : at;
        axis.tileStep = up ? stride : -stride;
        axis.borderStep = up ? 1 : -1;
        axis.border = view.borders[i] + at + up;
        cross(axis);
        return axis;
    };
    Axis column = start(0), row = start(1);
    const double depthAtEnd = part.end == kForever ? (part.dw > 0.0 ? kForever : part.depth)
                                                   : part.ow + part.end * part.dw;
    double begin = part.begin, depth = part.depth;

    // The tile up to where it is left. False where the walk ends there.
    const auto pass = [&](double end, double exitDepth) HWY_ATTR {
        const bool last = !(end < part.end);
        if (last) end = part.end, exitDepth = depthAtEnd;
        const TileDepths& bounds = view.depths[tile];
        const float near = (float) (std::min(depth, exitDepth) * (1.0 - kVisitDepthSlack));
        const float far =
            (float) std::min(std::max(depth, exitDepth) * (1.0 + kVisitDepthSlack), 0x1p100);
        if (((bounds.near <= far) & (near <= bounds.far)) &&
            (bounds.occupied & bounds.parts(near, far)) != 0)
            visit(Visit{begin, end * (1.0 + kVisitSlack), near, far, tile});
        begin = std::max(begin, end * (1.0 - kVisitSlack));
        depth = exitDepth;
        return !last;
    };
    const auto advance = [&](Axis& axis) HWY_ATTR {
        if (axis.left-- == 0) return false;
        tile += axis.tileStep;
        axis.border += axis.borderStep;
        cross(axis);
        return true;
    };
    // The branch on what comes next is foreseen well enough that the next crossing is under way
    // before this one is decided.
    while (begin <= limit) {
        ++steps;
        if (row.t < column.t) {
            if (!pass(row.t, row.depth) || !advance(row)) return;
        } else {
            if (!pass(column.t, column.depth) || !advance(column)) return;
        }
    }
}

} // namespace dirt::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
