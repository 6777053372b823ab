#include "backend_cpu/image/eye_tile.h"

#include "core/trace/holes.h"
#include "core/trace/intersect.h"

#include <algorithm>
#include <cmath>

// Compiles what follows once for each instruction set that Highway knows on this architecture.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "backend_cpu/image/eye_tile.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace dirt::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// 1/t beyond which t is not certainly a normal number.
constexpr float kLeast = 0x1p-60f, kMost = 0x1p60f;

/// Two t in doubt, or a hit in doubt: core decides.
void resolve(const FrameGeometry& geometry, uint32_t id, int pixel, EyeTile& tile) {
    const Ray ray = tile.ray(pixel);
    TriangleHit hit, seen;
    if (!intersect(ray, geometry.triangles[id], hit) ||
        !isHit(geometry, ray.direction, id, hit.u, hit.v))
        return;
    if (tile.id[pixel] != kNoPrimitive) {
        intersect(ray, geometry.triangles[tile.id[pixel]], seen);
        if (seen.t < hit.t || (seen.t == hit.t && tile.id[pixel] < id)) return;
    }
    const float inverse = std::min(1.0f / hit.t, kMost);
    tile.id[pixel] = id;
    tile.low[pixel] = inverse * (1.0f - 0x1p-20f); // t errs by 2^-23, 1/t too
    tile.high[pixel] = inverse * (1.0f + 0x1p-20f);
}

void testTriangle(const FrameGeometry& geometry, const EyeTriangle& item, float margin,
                  EyeTile& tile) {
    const hn::CappedTag<float, 16> d;
    const hn::RebindToUnsigned<decltype(d)> du;
    const int lanes = (int) hn::Lanes(d);
    const auto minusMargin = hn::Set(d, -margin), plusMargin = hn::Set(d, margin);
    const auto error = hn::Set(d, item.error);
    // What may have holes is always in doubt.
    const float surelyAbove = geometry.mayHaveHoles(item.id) ? HUGE_VALF : margin;
    const int x0 = std::max(0, item.range.x0 - tile.x0) / lanes * lanes;
    const int x1 = std::min(EyeTile::kWidth - 1, item.range.x1 - tile.x0);
    const int y0 = std::max(0, item.range.y0 - tile.y0);
    const int y1 = std::min(EyeTile::kHeight - 1, item.range.y1 - tile.y0);
    for (int y = y0; y <= y1; ++y)
        for (int x = x0; x <= x1; x += lanes) {
            const int pixel = y * EyeTile::kWidth + x;
            const auto dx = hn::Load(d, tile.direction[0] + pixel);
            const auto dy = hn::Load(d, tile.direction[1] + pixel);
            const auto dz = hn::Load(d, tile.direction[2] + pixel);
            const auto along = [&](const float* n) HWY_ATTR {
                return hn::Add(
                    hn::Add(hn::Mul(hn::Set(d, n[0]), dx), hn::Mul(hn::Set(d, n[1]), dy)),
                    hn::Mul(hn::Set(d, n[2]), dz));
            };
            const auto a = along(item.edge[0]), b = along(item.edge[1]), c = along(item.edge[2]);
            const auto least = hn::Min(hn::Min(a, b), c);
            auto met = hn::Ge(least, minusMargin);
            if (!item.clear) met = hn::Or(met, hn::Le(hn::Max(hn::Max(a, b), c), plusMargin));
            const auto inverse = along(item.inverse);
            // Of two t that are computed apart the exact ones may be nearer by 2^-23 of them.
            const auto high = hn::Mul(hn::Add(inverse, error), hn::Set(d, 1.0f + 0x1p-21f));
            met = hn::And(met, hn::Ge(high, hn::Load(d, tile.low + pixel)));
            if (hn::AllFalse(d, met)) continue;

            const auto low = hn::Sub(inverse, error);
            const auto seenHigh = hn::Load(d, tile.high + pixel);
            const auto normal =
                hn::And(hn::Gt(low, hn::Set(d, kLeast)), hn::Lt(high, hn::Set(d, kMost)));
            const auto inside =
                hn::And(hn::Gt(least, hn::Set(d, surelyAbove)), hn::Gt(low, seenHigh));
            const auto nearest = hn::And(met, hn::And(normal, inside));
            hn::Store(hn::IfThenElse(nearest, low, hn::Load(d, tile.low + pixel)), d,
                      tile.low + pixel);
            hn::Store(hn::IfThenElse(nearest, high, seenHigh), d, tile.high + pixel);
            hn::Store(hn::IfThenElse(hn::RebindMask(du, nearest), hn::Set(du, item.id),
                                     hn::Load(du, tile.id + pixel)),
                      du, tile.id + pixel);
            const auto doubtful = hn::AndNot(nearest, met);
            if (hn::AllFalse(d, doubtful)) continue;
            uint8_t bits[8] = {};
            hn::StoreMaskBits(d, doubtful, bits);
            for (uint32_t rest = (uint32_t) bits[0] | (uint32_t) bits[1] << 8; rest != 0;
                 rest &= rest - 1)
                resolve(geometry, item.id, pixel + (int) hwy::Num0BitsBelowLS1Bit_Nonzero32(rest),
                        tile);
        }
}

void RasterizeTile(const FrameGeometry& geometry, const std::vector<EyeTriangle>& items,
                   std::span<const DepthEntry> list, float margin, EyeTile& tile) {
    const hn::CappedTag<float, 16> d;
    for (size_t i = 0; i < list.size(); ++i) {
        if (i % 16 == 8) {
            auto low = hn::Set(d, HUGE_VALF);
            for (int pixel = 0; pixel < EyeTile::kPixels; pixel += (int) hn::Lanes(d))
                low = hn::Min(low, hn::Load(d, tile.low + pixel));
            // Everything that is left lies behind what all pixels see.
            const float least = hn::GetLane(hn::MinOfLanes(d, low));
            if (least > kLeast && list[i].near * least > 1.0f + 0x1p-19f) return;
        }
        testTriangle(geometry, items[list[i].item], margin, tile);
    }
}

} // namespace dirt::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dirt {

HWY_EXPORT(RasterizeTile);

void rasterizeTile(const FrameGeometry& geometry, const std::vector<EyeTriangle>& items,
                   std::span<const DepthEntry> list, float margin, EyeTile& tile) {
    HWY_DYNAMIC_DISPATCH(RasterizeTile)(geometry, items, list, margin, tile);
}

} // namespace dirt
#endif // HWY_ONCE
