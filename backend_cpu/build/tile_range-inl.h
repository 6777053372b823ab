// Which tiles triangles may overlap, several triangles at once. Included once for each instruction
// set.

#if defined(DIRT_TILE_RANGE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef DIRT_TILE_RANGE_INL_H_
#undef DIRT_TILE_RANGE_INL_H_
#else
#define DIRT_TILE_RANGE_INL_H_
#endif

#include "backend_cpu/build/load_triangles-inl.h"
#include "backend_cpu/build/raster_tables.h"
#include "backend_cpu/build/simd_mask-inl.h"
#include "core/grid/coverage.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace dirt::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// Positions. A vertex of slope x/w lies at p = (x/w) k + m, in tiles from the rim, k = n/(2S) and
// m = n/2 for n tiles in [-S, S]. In float, with u = 2^-24 and |x/w| <= S: the quotient, k (made of
// the rounded S) and the product add 4 u n/2 at most, m and the sum 1.5 u n: p is off by less than
// 4 u n = 1/512 of a tile for 8192 tiles. Beyond the rim p errs more, but to no other side of it
// than by that.
//
// Ranges. With c = floor(p), clamped to the tiles, the guard band of 1/128, and borders that move
// by less than 1/1365 in core's test (coverage.cpp): the vertex is behind the high border of tile
// c - 2, before that of tile c + 1, not before the low border of c - 1, and before that of c + 2.
// So core's bisection is left with the borders of c - 1, c and c + 1, and these are tested as it
// does. Core scales directions by a power of two; where no product underflows that changes no
// sign. With coordinates of 0 or between 2^-30 and 2^20, hence of 2^-51 or more when scaled, and
// borders of 0 or 2^-60 or more none does, and differences are multiples of 2^-74.

using WideTag = hn::CappedTag<float, 16>;
using WideIntTag = hn::RebindToSigned<WideTag>;
using Wide = hn::Vec<WideTag>;
using WideInts = hn::Vec<WideIntTag>;
inline constexpr size_t kMaxWide = 16;

inline constexpr float kSmallest = 0x1p-30f, kLargest = 0x1p20f; // of ordinary coordinates

using WideVertices = Vertices<WideTag>;

HWY_INLINE Wide min3(Wide a, Wide b, Wide c) {
    return hn::Min(hn::Min(a, b), c);
}
HWY_INLINE Wide max3(Wide a, Wide b, Wide c) {
    return hn::Max(hn::Max(a, b), c);
}

/// Triangles that lie in one tile alone, with 1/64 of a tile to spare on each side. The overlap
/// test never parts these from their tile (the margin is more than the 1/512 within which G1
/// makes it list everything), the clip finds all vertices inside it, and no other tile is in reach
/// of its guard band.
struct InOneTile {
    hn::Mask<WideTag> is;
    WideInts tile;  ///< over all views
    Wide near, far; ///< depths of the vertices

    HWY_INLINE InOneTile(const RasterTables& tables, const WideVertices& t) {
        const WideTag d;
        const WideIntTag di;
        Wide x[3], y[3], w[3];
        WideInts view = hn::Zero(di);
        if (tables.views == 1) {
            for (int v = 0; v < 3; ++v) x[v] = t.v[v][0], y[v] = t.v[v][1], w[v] = t.v[v][2];
        } else {
            // The face that the first vertex is seen in, if any.
            const Wide ax = hn::Abs(t.v[0][0]), ay = hn::Abs(t.v[0][1]), az = hn::Abs(t.v[0][2]);
            const auto onX = hn::And(hn::Ge(ax, ay), hn::Ge(ax, az));
            const auto onY = hn::Ge(ay, az);
            const auto pick = [&](Wide a, Wide b, Wide c) HWY_ATTR {
                return hn::IfThenElse(onX, a, hn::IfThenElse(onY, b, c));
            };
            const auto turn = [&](int v) HWY_ATTR {
                x[v] = pick(t.v[v][1], t.v[v][2], t.v[v][0]);
                y[v] = pick(t.v[v][2], t.v[v][0], t.v[v][1]);
                w[v] = pick(t.v[v][0], t.v[v][1], t.v[v][2]);
            };
            turn(0), turn(1), turn(2);
            const Wide sign = hn::And(w[0], hn::SignBit(d));
            for (Wide& depth : w) depth = hn::Xor(depth, sign);
            const Wide axis = pick(hn::Zero(d), hn::Set(d, 2.0f), hn::Set(d, 4.0f));
            view = hn::Add(hn::ConvertTo(di, axis),
                           hn::BitCast(di, hn::ShiftRight<31>(hn::BitCast(
                                               hn::RebindToUnsigned<WideTag>(), sign))));
        }
        near = min3(w[0], w[1], w[2]);
        far = max3(w[0], w[1], w[2]);
        is = hn::Ge(near, hn::Set(d, kSmallest));
        const WideInts column = tileOf(tables.axes[0], x, w);
        const WideInts row = tileOf(tables.axes[1], y, w);
        tile = hn::Add(hn::Add(hn::Mul(view, hn::Set(di, (int32_t) tables.tilesPerView)),
                               hn::Mul(row, hn::Set(di, tables.axes[0].tiles))),
                       column);
    }

private:
    HWY_INLINE WideInts tileOf(const RasterTables::Axis& axis, const Wide* x, const Wide* w) {
        const WideTag d;
        const WideIntTag di;
        const Wide k = hn::Set(d, axis.tilesPerSlope), m = hn::Set(d, axis.middle);
        const auto position = [&](int v)
                                  HWY_ATTR { return hn::Add(hn::Mul(hn::Div(x[v], w[v]), k), m); };
        const Wide p0 = position(0), p1 = position(1), p2 = position(2);
        const Wide low = min3(p0, p1, p2), high = max3(p0, p1, p2);
        const Wide tile = hn::Floor(low);
        const Wide margin = hn::Set(d, 1.0f / 64.0f);
        const Wide end = hn::Min(hn::Set(d, axis.end), hn::Add(tile, hn::Set(d, 1.0f)));
        is = hn::And(is, hn::And(hn::Ge(low, margin), hn::Ge(hn::Sub(low, tile), margin)));
        is = hn::And(is, hn::Le(high, hn::Sub(end, margin)));
        return hn::ConvertTo(di, hn::IfThenElseZero(is, tile));
    }
};

/// Ranges of tiles, one a lane.
struct TileRanges {
    HWY_ALIGN int32_t column0[kMaxWide], column1[kMaxWide], row0[kMaxWide], row1[kMaxWide];
    uint32_t simple = 0; ///< lanes whose range stands here, and is not empty
    uint32_t other = 0;  ///< lanes that are left to core's tileRange

    TileRange range(size_t lane) const {
        return {column0[lane], column1[lane], row0[lane], row1[lane]};
    }
};

/// First and last tile along one axis that the side planes do not separate from the triangle.
HWY_INLINE void rangeAlong(const RasterTables::Axis& axis, const Wide* x, const Wide* w,
                           WideInts& first, WideInts& last) {
    const WideTag d;
    const WideIntTag di;
    const Wide k = hn::Set(d, axis.tilesPerSlope), m = hn::Set(d, axis.middle);
    const Wide rightmost = hn::Set(d, (float) (axis.tiles - 1));
    const WideInts one = hn::Set(di, 1);
    first = hn::Set(di, axis.tiles), last = hn::Set(di, -1);
    for (int v = 0; v < 3; ++v) {
        const Wide p = hn::Add(hn::Mul(hn::Div(x[v], w[v]), k), m);
        const WideInts c = hn::ConvertTo(di, hn::Min(hn::Max(p, hn::Zero(d)), rightmost));
        const auto side = [&](const float* border) HWY_ATTR {
            return hn::Sub(x[v], hn::Mul(hn::GatherIndex(d, border, c), w[v]));
        };
        const auto isBehind = [&](Wide side) HWY_ATTR {
            return hn::IfThenElseZero(hn::RebindMask(di, hn::Gt(side, hn::Zero(d))), one);
        };
        const auto isNotBefore = [&](Wide side) HWY_ATTR {
            return hn::IfThenElseZero(hn::RebindMask(di, hn::Ge(side, hn::Zero(d))), one);
        };
        const WideInts before = hn::Sub(c, one);
        first = hn::Min(first, hn::Add(before, hn::Add(isBehind(side(axis.high - 1)),
                                                       isBehind(side(axis.high)))));
        last = hn::Max(last, hn::Add(before, hn::Add(isNotBefore(side(axis.low)),
                                                     isNotBefore(side(axis.low + 1)))));
    }
}

/// Lanes whose coordinates all are zero or of ordinary size.
HWY_INLINE hn::Mask<WideTag> areOrdinary(const WideVertices& t) {
    const WideTag d;
    const Wide zero = hn::Zero(d), least = hn::Set(d, kSmallest), most = hn::Set(d, kLargest);
    auto good = hn::Eq(zero, zero);
    for (const auto& vertex : t.v)
        for (const Wide& x : vertex) {
            const Wide size = hn::Abs(x);
            good = hn::And(
                good, hn::And(hn::Or(hn::Eq(size, zero), hn::Ge(size, least)), hn::Le(size, most)));
        }
    return good;
}

/// The tile ranges of several triangles in one view. \p ordinary are the lanes for which bounds
/// hold.
HWY_INLINE void findRanges(const RasterTables& tables, int view, const WideVertices& t,
                           hn::Mask<WideTag> ordinary, TileRanges& out) {
    const WideTag d;
    const WideIntTag di;
    const Wide zero = hn::Zero(d);
    Wide x[3], y[3], w[3], size[3];
    for (int v = 0; v < 3; ++v) {
        x[v] = t.v[v][tables.axis[0][view]];
        y[v] = t.v[v][tables.axis[1][view]];
        w[v] = hn::Mul(hn::Set(d, tables.sign[view]), t.v[v][tables.axis[2][view]]);
        size[v] = hn::Abs(w[v]);
    }
    // Beyond a rim by more than rounding, and wherever w changes its sign; so are then the
    // crossings of the edges with w = 0, and all borders behind the rim separate.
    const auto beyond = [&](const Wide* c, float slope) HWY_ATTR {
        const Wide s = hn::Set(d, slope);
        const auto at = [&](int v) HWY_ATTR { return hn::Mul(s, size[v]); };
        const Wide low = min3(hn::Sub(c[0], at(0)), hn::Sub(c[1], at(1)), hn::Sub(c[2], at(2)));
        const Wide high = max3(hn::Add(c[0], at(0)), hn::Add(c[1], at(1)), hn::Add(c[2], at(2)));
        return hn::Or(hn::Gt(low, zero), hn::Lt(high, zero));
    };
    const auto inFront = hn::Gt(max3(w[0], w[1], w[2]), zero);
    const auto aside = hn::Or(beyond(x, tables.axes[0].beyond), beyond(y, tables.axes[1].beyond));
    const auto near = hn::AndNot(hn::And(aside, ordinary), inFront);
    out.simple = out.other = 0;
    if (hn::AllFalse(d, near)) return;

    const auto simple = hn::And(near, hn::And(ordinary, hn::Gt(min3(w[0], w[1], w[2]), zero)));
    out.other = simdMaskBits(d, hn::AndNot(simple, near));
    for (Wide& depth : w) depth = hn::IfThenElse(simple, depth, hn::Set(d, 1.0f));
    for (Wide& c : x) c = hn::IfThenElseZero(simple, c);
    for (Wide& c : y) c = hn::IfThenElseZero(simple, c);
    WideInts column0, column1, row0, row1;
    rangeAlong(tables.axes[0], x, w, column0, column1);
    rangeAlong(tables.axes[1], y, w, row0, row1);
    hn::Store(column0, di, out.column0), hn::Store(column1, di, out.column1);
    hn::Store(row0, di, out.row0), hn::Store(row1, di, out.row1);
    const auto empty = hn::Or(hn::Gt(column0, column1), hn::Gt(row0, row1));
    out.simple = simdMaskBits(d, simple) & ~simdMaskBits(di, empty);
}

} // namespace dirt::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
