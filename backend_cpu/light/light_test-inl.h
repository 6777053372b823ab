// What the light grid says of a shadow ray. Included once for each instruction set.

#if defined(DIRT_LIGHT_TEST_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef DIRT_LIGHT_TEST_INL_H_
#undef DIRT_LIGHT_TEST_INL_H_
#else
#define DIRT_LIGHT_TEST_INL_H_
#endif

#include "backend_cpu/build/simd_mask-inl.h"
#include "backend_cpu/light/light_raster.h"
#include "core/base/denormals.h"
#include "core/trace/ray.h"

#include <cmath>

#include <hwy/cache_control.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace dirt::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// The origin of a ray to the light, seen from there, and the list it is looked up in.
struct LightRay {
    static constexpr uint32_t kNoTile = ~0u;

    float p[3];
    float distance; ///< largest |component|
    float depth;    ///< nothing listed beyond it is before the ray's origin
    uint32_t tile = kNoTile;
    uint32_t place; ///< in the tile: the bytes that a box's may not exceed

    /// Leaves no tile where the ray does not end in the light, or starts where no list is made.
    HWY_INLINE void set(const LightGrid& grid, const Ray& ray, float maxT) {
        tile = kNoTile;
        float size[3];
        bool ends = maxT <= 1.0f;
        for (int i = 0; i < 3; ++i) {
            ends &= flushed(grid.position[i] - ray.origin[i]) == ray.direction[i];
            p[i] = ray.origin[i] - grid.position[i];
            size[i] = std::abs(p[i]);
        }
        const int axis =
            size[0] > size[1] ? (size[0] > size[2] ? 0 : 2) : (size[1] > size[2] ? 1 : 2);
        distance = size[axis];
        if (!ends || !(distance <= grid.reach && distance >= grid.nearest)) return;
        const LightTree& tree = grid.tree;
        const LightFace& face = tree.faces[2 * axis + (p[axis] < 0.0f)];
        const float r = 1.0f / distance;
        const auto placeAlong = [&](int i) {
            return std::min((int) ((p[i] * r + 1.0f) * (float) kPlacesPerSlope),
                            (1 << kPlaceBits) - 1);
        };
        const int x = placeAlong(face.axisX), y = placeAlong(face.axisY);
        int shift = tree.rootShift;
        const uint32_t column = (uint32_t) ((x >> shift) - face.column);
        const uint32_t row = (uint32_t) ((y >> shift) - face.row);
        if (column >= (uint32_t) face.columns || row >= (uint32_t) face.rows) return;
        tile = tree.nodes[face.firstNode + row * (uint32_t) face.columns + column];
        while ((tile & LightTree::kInner) != 0) {
            shift -= LightTree::kSplitBits;
            tile = tree.nodes[(tile & ~LightTree::kInner) + (uint32_t) (y >> shift & 3) * 4 +
                              (uint32_t) (x >> shift & 3)];
        }
        constexpr uint32_t last = (1u << kUnitBits) - 1;
        const uint32_t inX = (uint32_t) (x >> (shift - kUnitBits)) & last;
        const uint32_t inY = (uint32_t) (y >> (shift - kUnitBits)) & last;
        place = inX | (last - inX) << 8 | inY << 16 | (last - inY) << 24;
        depth = distance * (1.0f + kLightBeyond);
        hwy::Prefetch(&grid.heads[tile]);
    }
    bool looksUp() const { return tile != kNoTile; }
};

/// Those of 16 entries from \p begin on, which may be before the ray's origin where it is, as bits.
HWY_INLINE uint32_t mayOcclude(const LightGrid& grid, size_t begin, const LightRay& ray) {
    constexpr size_t kEntries = LightGrid::kPadding;
    const hn::CappedTag<float, kEntries> d;
    const hn::RebindToUnsigned<decltype(d)> du;
    const auto depth = hn::Set(d, ray.depth);
    // Bytes have seven bits: of a difference with the eighth set, that stays where none is
    // exceeded.
    const auto eighth = hn::Set(du, 0x80808080u);
    const auto place = hn::Set(du, ray.place | 0x80808080u);
    uint32_t bits = 0;
    for (size_t i = 0; i < kEntries; i += hn::Lanes(d)) {
        const auto near = hn::LoadU(d, grid.near.data() + begin + i);
        const auto box = hn::LoadU(du, grid.box.data() + begin + i);
        const auto inside = hn::Eq(hn::And(hn::Sub(place, box), eighth), eighth);
        bits |= simdMaskBits(d, hn::And(hn::Le(near, depth), hn::RebindMask(d, inside))) << i;
    }
    return bits;
}

/// The triangles of a ray's list that may occlude it, some at a time.
struct LightCandidates {
    static constexpr size_t kEnough = 8;
    uint32_t id[kEnough - 1 + LightGrid::kPadding];
    size_t count;
    uint32_t next, end; ///< of the list, what has not been looked at

    HWY_INLINE void start(const LightGrid& grid, const LightRay& ray) {
        count = 0;
        next = grid.heads[ray.tile];
        end = grid.heads[ray.tile + 1];
        hwy::Prefetch(grid.near.data() + next);
        hwy::Prefetch(grid.box.data() + next);
        hwy::Prefetch(grid.id.data() + next);
    }

    HWY_INLINE void find(const LightGrid& grid, const LightRay& ray) {
        count = 0;
        while (next < end && count < kEnough) {
            const uint32_t first = next, entries = std::min(end - first, 16u);
            next += entries;
            uint32_t rest = mayOcclude(grid, first, ray) & (0xffffu >> (16 - entries));
            for (; rest != 0; rest &= rest - 1) {
                id[count] = grid.id[first + hwy::Num0BitsBelowLS1Bit_Nonzero32(rest)];
                hwy::Prefetch(&grid.records[id[count++]]);
            }
        }
    }
};

enum class LightTest { misses, mayHit, hits };

/// Whether the ray meets the triangle before the light: by the signs that are beyond doubt.
HWY_INLINE LightTest testRecord(const LightRecord& record, const LightRay& ray) {
    const hn::CappedTag<float, 4> d;
    const auto margin = hn::Set(d, record.margin * ray.distance);
    bool within = true;
    for (size_t lane = 0; lane < 4; lane += hn::Lanes(d)) {
        const auto last = hn::Eq(hn::Iota(d, (float) lane), hn::Set(d, 3.0f));
        const auto sum =
            hn::Add(hn::Add(hn::Mul(hn::Load(d, record.x + lane), hn::Set(d, ray.p[0])),
                            hn::Mul(hn::Load(d, record.y + lane), hn::Set(d, ray.p[1]))),
                    hn::Mul(hn::Load(d, record.z + lane), hn::Set(d, ray.p[2])));
        const auto value = hn::Sub(sum, hn::IfThenElseZero(last, hn::Set(d, record.offset)));
        if (!hn::AllFalse(d, hn::Lt(value, hn::Neg(margin)))) return LightTest::misses;
        within &= hn::AllTrue(d, hn::Gt(value, margin));
    }
    return within ? LightTest::hits : LightTest::mayHit;
}

} // namespace dirt::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
