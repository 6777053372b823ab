#include "backend_cpu/build/list_bins.h"

// Compiles what follows once for each instruction set that Highway knows on this architecture.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "backend_cpu/build/list_bins.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace dirt::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

static_assert(sizeof(Fragment) == 4 * sizeof(float));

void FindCells(std::span<const Fragment> fragments, uint32_t firstTile, int bins,
               const BinMaps& maps, uint32_t* firstCell, uint32_t* lastCell) {
    const hn::CappedTag<float, 16> d;
    const hn::RebindToSigned<decltype(d)> di;
    using V = hn::Vec<decltype(d)>;
    using VI = hn::Vec<decltype(di)>;
    const size_t lanes = hn::Lanes(d);
    const V lastBin = hn::Set(d, (float) (bins - 1));
    size_t i = 0;
    for (; i + lanes <= fragments.size(); i += lanes) {
        V tile, id, near, far;
        hn::LoadInterleaved4(d, reinterpret_cast<const float*>(&fragments[i]), tile, id, near, far);
        const VI local = hn::Sub(hn::BitCast(di, tile), hn::Set(di, (int32_t) firstTile));
        const V from = hn::GatherIndex(d, maps.near.data(), local);
        const V scale = hn::GatherIndex(d, maps.scale.data(), local);
        const VI cell = hn::Mul(local, hn::Set(di, bins));
        const auto bin = [&](V w) HWY_ATTR { // binOf
            const V at = hn::Mul(hn::Sub(w, from), scale);
            return hn::ConvertTo(di, hn::Min(hn::Max(at, hn::Zero(d)), lastBin));
        };
        hn::StoreU(hn::Add(cell, bin(near)), di, reinterpret_cast<int32_t*>(firstCell + i));
        hn::StoreU(hn::Add(cell, bin(far)), di, reinterpret_cast<int32_t*>(lastCell + i));
    }
    for (; i < fragments.size(); ++i) {
        const Fragment& fragment = fragments[i];
        const uint32_t tile = fragment.tile - firstTile;
        const auto bin = [&](float w) {
            return (uint32_t) binOf(w, maps.near[tile], maps.scale[tile], bins);
        };
        firstCell[i] = tile * (uint32_t) bins + bin(fragment.near);
        lastCell[i] = tile * (uint32_t) bins + bin(fragment.far);
    }
}

} // namespace dirt::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dirt {

HWY_EXPORT(FindCells);

void BinMaps::set(const Grid& grid, uint32_t firstTile, uint32_t tiles) {
    near.resize(tiles);
    scale.resize(tiles);
    int view = 0;
    for (uint32_t i = 0; i < tiles; ++i) {
        const uint32_t tile = firstTile + i;
        while (tile >= grid.firstTile[view + 1]) ++view;
        const BinMap map(grid.bounds(view, (int) (tile - grid.firstTile[view])),
                         grid.settings.bins);
        near[i] = map.near;
        scale[i] = map.scale;
    }
}

void findCells(std::span<const Fragment> fragments, uint32_t firstTile, int bins,
               const BinMaps& maps, uint32_t* firstCell, uint32_t* lastCell) {
    HWY_DYNAMIC_DISPATCH(FindCells)(fragments, firstTile, bins, maps, firstCell, lastCell);
}

} // namespace dirt
#endif // HWY_ONCE
