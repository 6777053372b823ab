// Triangles as the light sees them, several at once: where they lie, and their planes. Included
// once for each instruction set.

#if defined(DIRT_LIGHT_SETUP_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef DIRT_LIGHT_SETUP_INL_H_
#undef DIRT_LIGHT_SETUP_INL_H_
#else
#define DIRT_LIGHT_SETUP_INL_H_
#endif

#include "backend_cpu/build/load_triangles-inl.h"
#include "backend_cpu/build/simd_mask-inl.h"
#include "backend_cpu/light/light_raster.h"

#include <cfloat>
#include <cstring>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace dirt::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using LightTag = hn::CappedTag<double, 8>;
inline constexpr size_t kMaxLightLanes = 8;

/// The rectangles of roots, for each face, in places.
struct LightFaces {
    HWY_ALIGN int32_t x0[8] = {}, x1[8] = {}, y0[8] = {}, y1[8] = {};

    explicit LightFaces(const LightTree& tree) {
        for (int i = 0; i < 6; ++i) {
            const LightFace& face = tree.faces[i];
            x0[i] = face.column << tree.rootShift;
            x1[i] = ((face.column + face.columns) << tree.rootShift) - 1;
            y0[i] = face.row << tree.rootShift;
            y1[i] = ((face.row + face.rows) << tree.rootShift) - 1;
        }
    }
};

/// What lists triangles whose vertices all lie well inside one face, one a lane.
struct LightRanges {
    HWY_ALIGN int32_t x0[kMaxLightLanes], x1[kMaxLightLanes], y0[kMaxLightLanes],
        y1[kMaxLightLanes], face[kMaxLightLanes];
    HWY_ALIGN double guard[kMaxLightLanes], least[kMaxLightLanes];
    uint32_t simple; ///< lanes of such triangles, in reach of the face's roots
    uint32_t other;  ///< lanes of triangles that are not such
};

/// Several triangles, in double, less the light's position.
class LightLanes {
public:
    /// \p count of them from \p first on; the last again in the lanes that are left.
    HWY_INLINE LightLanes(const Triangle* triangles, size_t first, uint32_t count,
                          const glm::vec3& light) {
        const LightTag d;
        const hn::Rebind<int32_t, LightTag> di;
        const auto t = count == hn::Lanes(d)
                           ? Vertices<FloatTag>::from(triangles + first)
                           : Vertices<FloatTag>::at(
                                 triangles + first,
                                 hn::Min(hn::Iota(di, 0), hn::Set(di, (int32_t) count - 1)));
        for (int k = 0; k < 3; ++k)
            for (int axis = 0; axis < 3; ++axis) {
                world_[k][axis] = hn::PromoteTo(d, t.v[k][axis]);
                v_[k][axis] = hn::Sub(world_[k][axis], hn::Set(d, (double) light[axis]));
            }
    }

    HWY_INLINE void findRanges(const LightFaces& faces, const LightGrid& grid,
                               LightRanges& out) const {
        const LightTag d;
        const hn::Rebind<int32_t, LightTag> di;
        // The face that the first vertex is seen in.
        const V ax = hn::Abs(v_[0][0]), ay = hn::Abs(v_[0][1]), az = hn::Abs(v_[0][2]);
        const auto onX = hn::And(hn::Gt(ax, ay), hn::Gt(ax, az));
        const auto onY = hn::Gt(ay, az);
        const auto pick = [&](V a, V b, V c) HWY_ATTR {
            return hn::IfThenElse(onX, a, hn::IfThenElse(onY, b, c));
        };
        V x[3], y[3], w[3];
        for (int k = 0; k < 3; ++k) {
            x[k] = pick(v_[k][1], v_[k][2], v_[k][0]);
            y[k] = pick(v_[k][2], v_[k][0], v_[k][1]);
            w[k] = pick(v_[k][0], v_[k][1], v_[k][2]);
        }
        const auto negative = hn::Lt(w[0], hn::Zero(d));
        const V sign = hn::And(w[0], hn::SignBit(d));
        const V inner = hn::Set(d, 1.0 - kLightRim);
        for (V& depth : w) depth = hn::Xor(depth, sign);
        const V least = hn::Min(hn::Min(w[0], w[1]), w[2]);
        auto simple = hn::Gt(least, hn::Set(d, (double) grid.nearest));
        for (int k = 0; k < 3; ++k)
            simple = hn::And(simple,
                             hn::Lt(hn::Max(hn::Abs(x[k]), hn::Abs(y[k])), hn::Mul(w[k], inner)));
        out.other = ~simdMaskBits(d, simple);

        const V one = hn::Set(d, 1.0), perSlope = hn::Set(d, kPlacesPerSlope);
        V low[2], high[2], most = hn::Zero(d);
        for (int k = 0; k < 3; ++k) {
            const V r = hn::Div(one, hn::IfThenElse(simple, w[k], one));
            const V slope[2] = {hn::IfThenElseZero(simple, hn::Mul(x[k], r)),
                                hn::IfThenElseZero(simple, hn::Mul(y[k], r))};
            most = hn::Max(most, r);
            for (int i = 0; i < 2; ++i) {
                low[i] = k == 0 ? slope[i] : hn::Min(low[i], slope[i]);
                high[i] = k == 0 ? slope[i] : hn::Max(high[i], slope[i]);
            }
        }
        // As lightGuard.
        const V guard =
            hn::Add(hn::Mul(hn::Set(d, (double) grid.reach), most), hn::Set(d, kLightPlaces));
        const auto places = [&](V slope)
                                HWY_ATTR { return hn::Mul(hn::Add(slope, one), perSlope); };
        const auto first = [&](V slope) HWY_ATTR {
            return hn::DemoteTo(di, hn::Floor(hn::Sub(places(slope), guard)));
        };
        const auto last = [&](V slope) HWY_ATTR {
            return hn::DemoteTo(di, hn::Floor(hn::Add(places(slope), guard)));
        };
        const auto x0 = first(low[0]), x1 = last(high[0]);
        const auto y0 = first(low[1]), y1 = last(high[1]);
        const V axis = pick(hn::Zero(d), hn::Set(d, 2.0), hn::Set(d, 4.0));
        const auto face = hn::DemoteTo(di, hn::Add(axis, hn::IfThenElseZero(negative, one)));
        const auto at = [&](const int32_t* place)
                            HWY_ATTR { return hn::GatherIndex(di, place, face); };
        const auto aside = hn::Or(hn::Or(hn::Lt(x1, at(faces.x0)), hn::Gt(x0, at(faces.x1))),
                                  hn::Or(hn::Lt(y1, at(faces.y0)), hn::Gt(y0, at(faces.y1))));
        out.simple = ~out.other & ~simdMaskBits(di, aside);
        hn::Store(x0, di, out.x0), hn::Store(x1, di, out.x1);
        hn::Store(y0, di, out.y0), hn::Store(y1, di, out.y1);
        hn::Store(face, di, out.face);
        hn::Store(guard, d, out.guard), hn::Store(least, d, out.least);
    }

    /// The records of the lanes in \p which, the first lane's at \p records.
    HWY_INLINE void writeRecords(const LightGrid& grid, uint32_t which, LightRecord* records) const;

private:
    using FloatTag = hn::Rebind<float, LightTag>;
    using V = hn::Vec<LightTag>;

    V world_[3][3], v_[3][3]; ///< vertex, axis
};

/// The planes, scaled so that the edges' largest normal has the norm 1, and that of the triangle
/// too.
///
/// The margin. Of an edge's plane e = b x c, seen from the light, a ray's exact determinant is
/// d . ((b - o) x (c - o)), and with d = -p + f, |f_i| <= u |p_i|, that is -e . p but for
/// f . ((b - p) x (c - b)), less than u |p| (|e|_1 + 2 |p| |c - b|_1). The float evaluation of e .
/// p adds 5 u |e|_1 |p| (e, p, the products and two sums), the cross product in double 2^-48 size^2
/// |p|. Of the own plane, n . p - offset, the sign is that of n . (o - a) exactly. Here it is off
/// by 5 u |p| and 2 u |offset|, and by a = (2^-48 length^2 / |n|_1 + 2^-51) size from double, and
/// |p| is not below `nearest`. An |offset| above 2 |p| leaves more than half of it, beyond doubt.
/// So a lane beyond the margin has the exact sign. Errors in double are those of LightTriangle.
HWY_INLINE void LightLanes::writeRecords(const LightGrid& grid, uint32_t which,
                                         LightRecord* records) const {
    const LightTag d;
    const FloatTag df;
    struct Vec3 {
        V x, y, z;
    };
    const auto vector = [](const V* v) HWY_ATTR { return Vec3{v[0], v[1], v[2]}; };
    const auto minus = [](const V* a, const V* b) HWY_ATTR {
        return Vec3{hn::Sub(a[0], b[0]), hn::Sub(a[1], b[1]), hn::Sub(a[2], b[2])};
    };
    const auto cross = [](const Vec3& a, const Vec3& b) HWY_ATTR {
        return Vec3{hn::Sub(hn::Mul(a.y, b.z), hn::Mul(b.y, a.z)),
                    hn::Sub(hn::Mul(a.z, b.x), hn::Mul(b.z, a.x)),
                    hn::Sub(hn::Mul(a.x, b.y), hn::Mul(b.x, a.y))};
    };
    const auto sum = [](const Vec3& a) HWY_ATTR {
        return hn::Add(hn::Add(hn::Abs(a.x), hn::Abs(a.y)), hn::Abs(a.z));
    };
    const auto largest = [](const Vec3& a) HWY_ATTR {
        return hn::Max(hn::Max(hn::Abs(a.x), hn::Abs(a.y)), hn::Abs(a.z));
    };
    const auto max3 = [](V a, V b, V c) HWY_ATTR { return hn::Max(hn::Max(a, b), c); };
    const auto set = [&](double value) HWY_ATTR { return hn::Set(d, value); };

    const Vec3 a = vector(v_[0]), b = vector(v_[1]), c = vector(v_[2]);
    const Vec3 edges[3] = {cross(b, c), cross(c, a), cross(a, b)};
    const Vec3 ab = minus(world_[1], world_[0]), ac = minus(world_[2], world_[0]);
    const Vec3 normal = cross(ab, ac);
    const V determinant =
        hn::Add(hn::Add(hn::Mul(a.x, normal.x), hn::Mul(a.y, normal.y)), hn::Mul(a.z, normal.z));
    const V length = hn::Max(largest(ab), largest(ac)), squaredLength = hn::Mul(length, length);
    const V size = max3(largest(a), largest(b), largest(c)), squaredSize = hn::Mul(size, size);
    const V own = sum(normal);
    const V scale = max3(sum(edges[0]), sum(edges[1]), sum(edges[2]));
    const V lengths =
        max3(sum(minus(v_[1], v_[0])), sum(minus(v_[2], v_[1])), sum(minus(v_[0], v_[2])));
    const V error =
        hn::Add(hn::Mul(set(kLightError), squaredLength), hn::Mul(set(kLightNormalError), own));
    const V unclear = hn::Mul(error, size);
    auto clear = hn::And(hn::Gt(hn::Abs(determinant), unclear), hn::Gt(scale, hn::Zero(d)));
    const V one = set(1.0);
    const V perScale = hn::Div(one, hn::IfThenElse(clear, scale, one));
    const V perOwn = hn::Div(one, hn::IfThenElse(clear, own, one));
    const V farther = hn::Add(one, hn::Mul(size, set(1.0 / grid.nearest)));
    const V rounding =
        hn::Add(hn::Mul(hn::Mul(set(kLightError), squaredSize), perScale),
                hn::Mul(hn::Add(hn::Mul(hn::Mul(set(kLightOwnError), squaredLength), perOwn),
                                set(kLightOwnRounding)),
                        farther));
    const V lateral = hn::Mul(hn::Mul(set(2.5 * grid.reach), lengths), perScale);
    const V margin = hn::Add(hn::Mul(set(kLightRecord), hn::Add(set(16.0), lateral)), rounding);
    clear = hn::And(clear, hn::Lt(margin, set(0.5)));

    const V sign = hn::And(determinant, hn::SignBit(d));
    const V edgeScale = hn::Xor(perScale, sign), ownScale = hn::Xor(perOwn, sign);
    // One column of four floats a lane: those of x, of y, of z, and the last.
    HWY_ALIGN float columns[4][4 * kMaxLightLanes];
    const auto store = [&](V v0, V v1, V v2, V v3, float* column) HWY_ATTR {
        const auto part = [&](V v) HWY_ATTR { return hn::DemoteTo(df, v); };
        hn::StoreInterleaved4(part(v0), part(v1), part(v2), part(v3), df, column);
    };
    const auto scaled = [&](V Vec3::*axis, float* column) HWY_ATTR {
        const auto component = [&](V value, V by) HWY_ATTR {
            return hn::IfThenElseZero(clear, hn::Mul(value, by));
        };
        store(component(edges[0].*axis, edgeScale), component(edges[1].*axis, edgeScale),
              component(edges[2].*axis, edgeScale), component(normal.*axis, ownScale), column);
    };
    scaled(&Vec3::x, columns[0]);
    scaled(&Vec3::y, columns[1]);
    scaled(&Vec3::z, columns[2]);
    const V offset = hn::IfThenElseZero(clear, hn::Mul(determinant, ownScale));
    // A margin that decides nothing where the planes are not clear.
    store(offset, hn::IfThenElse(clear, margin, set(FLT_MAX)), hn::Zero(d), hn::Zero(d),
          columns[3]);
    for (; which != 0; which &= which - 1) {
        const size_t lane = hwy::Num0BitsBelowLS1Bit_Nonzero32(which);
        auto* const record = reinterpret_cast<float*>(records + lane);
        for (int i = 0; i < 4; ++i)
            std::memcpy(record + 4 * i, columns[i] + 4 * lane, 4 * sizeof(float));
    }
}

} // namespace dirt::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
