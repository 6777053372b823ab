// What the light grid says of a shadow ray. Included once for each instruction set.

#if defined(DIRT_LIGHT_TEST_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef DIRT_LIGHT_TEST_INL_H_
#undef DIRT_LIGHT_TEST_INL_H_
#else
#define DIRT_LIGHT_TEST_INL_H_
#endif

#include "backend_cpu/light_grid.h"
#include "core/grid/denormals.h"
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
        const LightFace& face = grid.faces[2 * axis + (p[axis] < 0.0f)];
        const float half = 0.5f * (float) grid.tiles, r = 1.0f / distance;
        const auto tileAlong = [&](int i) {
            return std::min((int) ((p[i] * r + 1.0f) * half), grid.tiles - 1);
        };
        const uint32_t column = (uint32_t) (tileAlong(face.axisX) - face.column);
        const uint32_t row = (uint32_t) (tileAlong(face.axisY) - face.row);
        if (column >= (uint32_t) face.columns || row >= (uint32_t) face.rows) return;
        tile = face.firstTile + row * (uint32_t) face.columns + column;
        // A point of the ray is at most (1 + 2^-24) as deep as its origin.
        depth = distance * (1.0f + 0x1p-20f);
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
