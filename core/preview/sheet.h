#pragma once

#include "core/grid/grid.h"

namespace dirt {

/// Where the cells of a level of all views' pyramids lie in one picture, a pixel each: one view
/// alone, or six in two rows of three.
struct Sheet {
    int columns, rows; ///< of a view
    int across;        ///< views in a row

    Sheet(const Grid& grid, int level)
        : columns(grid.pyramids[0].levels[(size_t) level].columns),
          rows(grid.pyramids[0].levels[(size_t) level].rows),
          across(grid.views.size() > 1 ? 3 : 1) {}

    int width() const { return across * columns; }
    int height(const Grid& grid) const { return (int) grid.views.size() / across * rows; }
    int left(size_t view) const { return (int) view % across * columns; }
    int top(size_t view) const { return (int) view / across * rows; }
};

} // namespace dirt
