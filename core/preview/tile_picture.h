#pragma once

#include "core/explain/listing.h"
#include "core/preview/picture.h"

#include <string>

namespace dirt {

/// What a tile lists: on the left the polygons of its \p entries (of entriesOfTile) as the eye sees
/// them, on the right their depths over the tile's bins. What is wrong is red.
Picture drawEntries(const Grid& grid, const std::vector<TileEntry>& entries, int view, int column,
                    int row, const std::string& title);

} // namespace dirt
