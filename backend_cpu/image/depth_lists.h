#pragma once

#include "core/base/executor.h"

#include <cstdint>
#include <span>
#include <vector>

namespace dirt {

/// Something in a tile, none of it nearer there than `near`.
struct DepthFragment {
    uint32_t tile, item;
    float near;
};

/// An entry of a tile's list.
struct DepthEntry {
    float near;
    uint32_t item;
};

/// Lists of tiles in the order of depth, at equal depth of items.
struct DepthLists {
    std::vector<uint32_t> heads; ///< tiles + 1
    std::vector<DepthEntry> entries;

    std::span<const DepthEntry> list(size_t tile) const {
        return {entries.data() + heads[tile], entries.data() + heads[tile + 1]};
    }
    uint64_t bytes() const {
        return heads.size() * sizeof(uint32_t) + entries.size() * sizeof(DepthEntry);
    }
};

/// Fragments that one piece of a loop found. Its items are counted from 0; \p firstItem is added.
struct FragmentPiece {
    std::span<const DepthFragment> fragments;
    uint32_t firstItem = 0;
};

/// Sorts fragments into the lists of \p tiles tiles, whose memory is used again: the same for any
/// number of threads.
void sortIntoTiles(std::span<const FragmentPiece> pieces, size_t tiles, Executor& executor,
                   DepthLists& lists);

} // namespace dirt
