#pragma once

#include "backend_cpu/build/fragments.h"
#include "core/grid/grid.h"

#include <cstdint>
#include <span>
#include <vector>

namespace dirt {

/// BinMaps of consecutive tiles as SIMD reads them.
struct BinMaps {
    std::vector<float> near, scale;

    /// Those of \p tiles tiles from \p firstTile, in the numbering over all views.
    void set(const Grid& grid, uint32_t firstTile, uint32_t tiles);
};

/// First and last cell that each fragment is listed in, by its tile's BinMap. Cells count from
/// that of bin 0 of \p firstTile, the first of \p maps.
void findCells(std::span<const Fragment> fragments, uint32_t firstTile, int bins,
               const BinMaps& maps, uint32_t* firstCell, uint32_t* lastCell);

/// At most so many fragments may be given at once; the results have room for all of them.
inline constexpr size_t kFragmentsAtOnce = 64;

} // namespace dirt
