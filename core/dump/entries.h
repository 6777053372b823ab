#pragma once

#include "core/grid/grid.h"

#include <cstdint>
#include <vector>

namespace dirt {

/// One entry of the id buffer with the depths that put it there.
struct ListEntry {
    uint32_t id, bin, view;
    float near, far; ///< depths of the primitive's part in the tile
};
static_assert(sizeof(ListEntry) == 20);

/// The entries of every tile of \p view, each tile's in the order (bin, near, id). The lists are
/// \p grid's; the depths come from clipping \p geometry to the tiles anew. An entry that the
/// clip does not confirm, which only a broken grid has, gets an empty interval (near > far).
std::vector<std::vector<ListEntry>> listEntriesOf(const Grid& grid, const FrameGeometry& geometry,
                                                  int view);

} // namespace dirt
