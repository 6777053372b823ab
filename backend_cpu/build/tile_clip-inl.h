// The overlap test and the clip of core's coverage.cpp and clip.cpp for several pairs of a triangle
// and a tile at once. Included once for each instruction set.

#if defined(DIRT_TILE_CLIP_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef DIRT_TILE_CLIP_INL_H_
#undef DIRT_TILE_CLIP_INL_H_
#else
#define DIRT_TILE_CLIP_INL_H_
#endif

#include "backend_cpu/build/raster_tables.h"
#include "backend_cpu/build/simd_mask-inl.h"
#include "shaders/shared/margins.h"

#include <cfloat>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace dirt::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// A triangle, counted from the first of a piece, and a tile that it may overlap.
struct TilePair {
    uint32_t triangle;
    uint32_t place; ///< view, row, column: 3, 13, 13 bits

    static uint32_t placeOf(int view, int row, int column) {
        return (uint32_t) view << 26 | (uint32_t) row << 13 | (uint32_t) column;
    }
    int view() const { return (int) (place >> 26); }
    int row() const { return (int) (place >> 13 & 8191); }
    int column() const { return (int) (place & 8191); }
};

using DoubleTag = hn::CappedTag<double, 8>;
using FloatTag = hn::Rebind<float, DoubleTag>;
using IntTag = hn::Rebind<int32_t, DoubleTag>;
using Doubles = hn::Vec<DoubleTag>;
using Floats = hn::Vec<FloatTag>;
using Ints = hn::Vec<IntTag>;
inline constexpr size_t kMaxLanes = 8;

/// Depths rounded outwards to float, by the bits of the double: core's roundDown and roundUp, with
/// the clip's margin. \p near and \p far are not negative.
HWY_INLINE Floats roundNear(Doubles near) {
    const DoubleTag d;
    const hn::RebindToSigned<DoubleTag> di;
    const FloatTag df;
    const Doubles x = hn::Min(hn::Mul(near, hn::Set(d, 1.0 - kDepthMargin)), hn::Set(d, FLT_MAX));
    const Doubles down =
        hn::BitCast(d, hn::And(hn::BitCast(di, x), hn::Set(di, ~((int64_t(1) << 29) - 1))));
    return hn::DemoteTo(df, hn::IfThenElseZero(hn::Ge(x, hn::Set(d, FLT_MIN)), down));
}
HWY_INLINE Floats roundFar(Doubles far) {
    const DoubleTag d;
    const hn::RebindToSigned<DoubleTag> di;
    const FloatTag df;
    const Doubles x = hn::Min(hn::Mul(far, hn::Set(d, 1.0 + kDepthMargin)), hn::Set(d, FLT_MAX));
    const auto below = hn::Set(di, (int64_t(1) << 29) - 1);
    const Doubles up = hn::BitCast(d, hn::AndNot(below, hn::Add(hn::BitCast(di, x), below)));
    return hn::DemoteTo(df, hn::Max(up, hn::Set(d, FLT_MIN)));
}

/// A vector a lane, of doubles.
struct Vec3 {
    Doubles x, y, z;
};

/// a x b, each component the difference of two exact products, rounded once.
HWY_INLINE Vec3 cross(const Vec3& a, const Vec3& b) {
    return {hn::Sub(hn::Mul(a.y, b.z), hn::Mul(b.y, a.z)),
            hn::Sub(hn::Mul(a.z, b.x), hn::Mul(b.z, a.x)),
            hn::Sub(hn::Mul(a.x, b.y), hn::Mul(b.x, a.y))};
}
HWY_INLINE Doubles sum3(Doubles x, Doubles y, Doubles z) {
    return hn::Add(hn::Add(x, y), z);
}
HWY_INLINE auto isZero(const Vec3& v) {
    const DoubleTag d;
    const Doubles all = hn::Or(hn::Or(v.x, v.y), v.z);
    return hn::Eq(hn::Abs(all), hn::Zero(d));
}

/// What came of a batch of pairs, one bit a lane.
struct ClipResult {
    uint32_t listed; ///< near and far are set
    uint32_t doubt;  ///< needs core's exact arithmetic; the bit above means nothing
    HWY_ALIGN float near[kMaxLanes], far[kMaxLanes];
};

/// One batch of pairs in the making.
class TileClip {
public:
    TileClip(const RasterTables& tables, const float* vertices, const TilePair* pairs) {
        const IntTag di;
        Ints triangle, place;
        hn::LoadInterleaved2(di, reinterpret_cast<const int32_t*>(pairs), triangle, place);
        const Ints view = hn::ShiftRight<26>(place);
        const Ints base = hn::Add(hn::ShiftLeft<3>(triangle), triangle);
        const FloatTag df;
        const Ints x = hn::Add(base, hn::GatherIndex(di, tables.axis[0], view));
        const Ints y = hn::Add(base, hn::GatherIndex(di, tables.axis[1], view));
        const Ints w = hn::Add(base, hn::GatherIndex(di, tables.axis[2], view));
        const Floats sign = hn::GatherIndex(df, tables.sign, view);
        const auto vertex = [&](int v) HWY_ATTR {
            const DoubleTag d;
            const float* at = vertices + 3 * v;
            return Vec3{hn::PromoteTo(d, hn::GatherIndex(df, at, x)),
                        hn::PromoteTo(d, hn::GatherIndex(df, at, y)),
                        hn::PromoteTo(d, hn::Mul(sign, hn::GatherIndex(df, at, w)))};
        };
        v0_ = vertex(0), v1_ = vertex(1), v2_ = vertex(2);
        const Ints thirteen = hn::Set(di, 8191);
        const Ints column = hn::And(place, thirteen);
        const Ints row = hn::And(hn::ShiftRight<13>(place), thirteen);
        s0_ = hn::GatherIndex(df, tables.axes[0].low, column);
        s1_ = hn::GatherIndex(df, tables.axes[0].high, column);
        t0_ = hn::GatherIndex(df, tables.axes[1].low, row);
        t1_ = hn::GatherIndex(df, tables.axes[1].high, row);
    }

    HWY_INLINE void run(ClipResult& result) {
        const DoubleTag d;
        const FloatTag df;
        n0_ = cross(v0_, v1_), n1_ = cross(v1_, v2_), n2_ = cross(v2_, v0_);
        orient();
        const auto flip = hn::Lt(det_, hn::Zero(d));
        const auto edgeOn = hn::Eq(edgeOnFloats(), hn::Zero(df));
        const auto separated =
            hn::Or(hn::Or(separates(n0_, flip, edgeOn), separates(n1_, flip, edgeOn)),
                   separates(n2_, flip, edgeOn));
        const uint32_t open = ~simdMaskBits(df, separated) & ((1u << hn::Lanes(d)) - 1);

        near_ = hn::Set(d, HUGE_VAL), far_ = hn::Zero(d);
        const auto inside = includeVertices();
        if ((open & ~simdMaskBits(d, inside)) != 0) {
            const auto doubtBefore = doubt_;
            doubt_ = hn::Lt(hn::Zero(d), hn::Zero(d));
            const Doubles near = near_, far = far_;
            includeOutline();
            near_ = hn::IfThenElse(inside, near, near_);
            far_ = hn::IfThenElse(inside, far, far_);
            doubt_ = hn::Or(doubtBefore, hn::AndNot(inside, doubt_));
        }
        hn::Store(roundNear(near_), df, result.near);
        hn::Store(roundFar(far_), df, result.far);
        result.doubt = simdMaskBits(d, doubt_);
        result.listed = open & simdMaskBits(d, hn::Gt(far_, hn::Zero(d)));
    }

private:
    using Mask = hn::Mask<DoubleTag>;

    /// The orientation from one vertex against the opposite edge; certain lanes as a mask.
    HWY_INLINE Doubles orientation(const Vec3& n, const Vec3& v, Mask& certain) const {
        const DoubleTag d;
        const Doubles x = hn::Mul(n.x, v.x), y = hn::Mul(n.y, v.y), z = hn::Mul(n.z, v.z);
        const Doubles value = sum3(x, y, z);
        const Doubles size = sum3(hn::Abs(x), hn::Abs(y), hn::Abs(z));
        certain = hn::Gt(hn::Abs(value), hn::Mul(hn::Set(d, kSignDoubt), size));
        return value;
    }

    HWY_INLINE void orient() {
        const DoubleTag d;
        const Mask flat = hn::Or(hn::Or(isZero(n0_), isZero(n1_)), isZero(n2_));
        Mask certain0, certain1, certain2;
        det_ = orientation(n0_, v2_, certain0);
        doubt_ = hn::Not(hn::Or(certain0, flat));
        if (!hn::AllFalse(d, doubt_)) {
            const Doubles second = orientation(n1_, v0_, certain1);
            const Doubles third = orientation(n2_, v1_, certain2);
            det_ = hn::IfThenElse(certain0, det_, hn::IfThenElse(certain1, second, third));
            doubt_ = hn::AndNot(hn::Or(certain1, certain2), doubt_);
        }
        det_ = hn::IfThenZeroElse(flat, det_);
    }

    /// Not zero where the determinant is not, in float.
    HWY_INLINE Floats edgeOnFloats() const {
        const DoubleTag d;
        const Doubles one = hn::Set(d, 1.0);
        return hn::DemoteTo(FloatTag(), hn::IfThenZeroElse(hn::Eq(det_, hn::Zero(d)), one));
    }

    /// core's scaledToUnit, then the edge's part of edgesSeparate.
    template <class FloatMask>
    HWY_INLINE FloatMask separates(const Vec3& normal, Mask flip, FloatMask edgeOn) const {
        const DoubleTag d;
        const FloatTag df;
        const hn::RebindToSigned<DoubleTag> di;
        const Doubles largest =
            hn::Max(hn::Max(hn::Abs(normal.x), hn::Abs(normal.y)), hn::Abs(normal.z));
        // 2^-e for a largest of m 2^e, m in [0.5, 1): of the biased exponents, 1023 - (E - 1022).
        const auto exponent = hn::ShiftRight<52>(hn::BitCast(di, largest));
        Doubles scale = hn::BitCast(d, hn::ShiftLeft<52>(hn::Sub(hn::Set(di, 2045), exponent)));
        scale = hn::IfThenElse(flip, hn::Neg(scale), scale);
        const auto component = [&](Doubles x) HWY_ATTR {
            const Floats f = hn::DemoteTo(df, hn::Mul(x, scale));
            return hn::IfThenZeroElse(hn::Lt(hn::Abs(f), hn::Set(df, FLT_MIN)), f);
        };
        const Floats x = component(normal.x), y = component(normal.y), z = component(normal.z);
        const Floats zero = hn::Zero(df);
        const auto right = hn::Gt(x, zero), below = hn::Gt(y, zero);
        const auto value = [&](Floats s, Floats t) HWY_ATTR {
            return hn::Add(hn::Add(hn::Mul(x, s), hn::Mul(y, t)), z);
        };
        const Floats farthest =
            value(hn::IfThenElse(right, s1_, s0_), hn::IfThenElse(below, t1_, t0_));
        const Floats nearest =
            value(hn::IfThenElse(right, s0_, s1_), hn::IfThenElse(below, t0_, t1_));
        return hn::Or(hn::Lt(farthest, zero), hn::And(edgeOn, hn::Gt(nearest, zero)));
    }

    HWY_INLINE void include(Mask valid, Doubles depth) {
        const DoubleTag d;
        near_ = hn::Min(near_, hn::IfThenElse(valid, depth, hn::Set(d, HUGE_VAL)));
        far_ = hn::Max(far_, hn::IfThenElseZero(valid, depth));
    }

    /// x - s w: the signed distances of the vertices from a border, unsigned by the side.
    HWY_INLINE Vec3 distances(int axis, Doubles slope) const {
        const auto one = [&](const Vec3& v) HWY_ATTR {
            return hn::Sub(axis == 0 ? v.x : v.y, hn::Mul(slope, v.z));
        };
        return {one(v0_), one(v1_), one(v2_)};
    }

    /// Lanes whose three vertices all are inside.
    HWY_INLINE Mask includeVertices() {
        const DoubleTag d;
        const Doubles zero = hn::Zero(d);
        S0_ = hn::PromoteTo(d, s0_), S1_ = hn::PromoteTo(d, s1_);
        T0_ = hn::PromoteTo(d, t0_), T1_ = hn::PromoteTo(d, t1_);
        left_ = distances(0, S0_), right_ = distances(0, S1_);
        top_ = distances(1, T0_), bottom_ = distances(1, T1_);
        const auto one = [&](const Vec3& v, Doubles l, Doubles r, Doubles t, Doubles b) HWY_ATTR {
            const Mask in = hn::And(hn::And(hn::Ge(l, zero), hn::Le(r, zero)),
                                    hn::And(hn::Ge(t, zero), hn::Le(b, zero)));
            const Mask valid = hn::And(in, hn::Ge(v.z, zero));
            include(valid, v.z);
            return valid;
        };
        return hn::And(hn::And(one(v0_, left_.x, right_.x, top_.x, bottom_.x),
                               one(v1_, left_.y, right_.y, top_.y, bottom_.y)),
                       one(v2_, left_.z, right_.z, top_.z, bottom_.z));
    }

    /// n . (s, t, 1); lanes in doubt are noted.
    HWY_INLINE Doubles edgeAtCorner(const Vec3& n, Mask flat, Doubles x, Doubles y) {
        const DoubleTag d;
        const Doubles value = sum3(x, y, n.z);
        const Doubles size = sum3(hn::Abs(x), hn::Abs(y), hn::Abs(n.z));
        const Mask certain = hn::Gt(hn::Abs(value), hn::Mul(hn::Set(d, kSignDoubt), size));
        doubt_ = hn::Or(doubt_, hn::Not(hn::Or(certain, flat)));
        return value;
    }

    /// Where edge ab crosses one side of the tile, between its corners with values p and q.
    HWY_INLINE void includeCrossing(Doubles numerator, Doubles da, Doubles db, Doubles p,
                                    Doubles q) {
        const DoubleTag d;
        const Doubles zero = hn::Zero(d);
        // The signs of products: no factor is below 2^-300, unless it is zero.
        const Mask crosses = hn::AndNot(hn::Gt(hn::Mul(p, q), zero), hn::Lt(hn::Mul(da, db), zero));
        const Doubles depth = hn::Div(numerator, hn::Sub(db, da));
        include(hn::And(crosses, hn::Ge(depth, zero)), depth);
    }

    /// The three values of the corners of one edge plane, and the edge's crossings.
    struct Corners {
        Doubles c00, c10, c01, c11;
    };
    HWY_INLINE Corners includeEdge(const Vec3& n, Doubles la, Doubles lb, Doubles ra, Doubles rb,
                                   Doubles ta, Doubles tb, Doubles ba, Doubles bb) {
        const Mask flat = isZero(n);
        const Doubles x0 = hn::Mul(n.x, S0_), x1 = hn::Mul(n.x, S1_);
        const Doubles y0 = hn::Mul(n.y, T0_), y1 = hn::Mul(n.y, T1_);
        const Corners e{edgeAtCorner(n, flat, x0, y0), edgeAtCorner(n, flat, x1, y0),
                        edgeAtCorner(n, flat, x0, y1), edgeAtCorner(n, flat, x1, y1)};
        const Doubles minusX = hn::Neg(n.x);
        includeCrossing(n.y, la, lb, e.c00, e.c01);
        includeCrossing(n.y, ra, rb, e.c10, e.c11);
        includeCrossing(minusX, ta, tb, e.c00, e.c10);
        includeCrossing(minusX, ba, bb, e.c01, e.c11);
        return e;
    }

    /// Where the ray through a corner meets the triangle.
    HWY_INLINE void includeCorner(Doubles ab, Doubles bc, Doubles ca) {
        const DoubleTag d;
        const Doubles zero = hn::Zero(d);
        const Mask positive = hn::Gt(hn::Max(hn::Max(ab, bc), ca), zero);
        const Mask negative = hn::Lt(hn::Min(hn::Min(ab, bc), ca), zero);
        const Doubles depth = hn::Div(det_, sum3(ab, bc, ca));
        include(hn::And(hn::Xor(positive, negative), hn::Ge(depth, zero)), depth);
    }

    HWY_INLINE void includeOutline() {
        const Corners a = includeEdge(n0_, left_.x, left_.y, right_.x, right_.y, top_.x, top_.y,
                                      bottom_.x, bottom_.y);
        const Corners b = includeEdge(n1_, left_.y, left_.z, right_.y, right_.z, top_.y, top_.z,
                                      bottom_.y, bottom_.z);
        const Corners c = includeEdge(n2_, left_.z, left_.x, right_.z, right_.x, top_.z, top_.x,
                                      bottom_.z, bottom_.x);
        includeCorner(a.c00, b.c00, c.c00);
        includeCorner(a.c10, b.c10, c.c10);
        includeCorner(a.c01, b.c01, c.c01);
        includeCorner(a.c11, b.c11, c.c11);
    }

    Vec3 v0_, v1_, v2_;         ///< vertices in their view's frame (x, y, w)
    Vec3 n0_, n1_, n2_;         ///< edge normals ab, bc, ca
    Doubles det_;               ///< a . (b x c)
    Floats s0_, s1_, t0_, t1_;  ///< guard-banded borders,
    Doubles S0_, S1_, T0_, T1_; ///< and again
    Vec3 left_, right_, top_, bottom_;
    Doubles near_, far_;
    Mask doubt_;
};

} // namespace dirt::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
