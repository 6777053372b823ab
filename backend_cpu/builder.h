#pragma once

#include "core/frame/executor.h"
#include "core/grid/grid.h"

#include <vector>

namespace dirt {

/// A triangle's part in one tile, as the software rasterizer finds it.
struct Fragment {
    uint32_t tile; ///< in the numbering over all views (Grid::firstTile)
    uint32_t id;
    float near, far;
};

/// The construction passes, spread over an Executor. Each gives the bits of buildGrid (core), which
/// is its oracle, for any number of threads.
class GridBuilder {
public:
    explicit GridBuilder(Executor& executor) : executor_(executor) {}

    /// Depth bounds of every tile; keeps the fragments for fillPrimitives.
    void fillDepth(const FrameGeometry& geometry, Grid& grid);
    /// Depth pyramid of every view.
    void fillDepthMipmap(Grid& grid);
    /// The id buffer, from the fragments of fillDepth and the depth bounds in \p grid.
    void fillPrimitives(const FrameGeometry& geometry, Grid& grid);

private:
    void countEntries(Grid& grid);
    void sumHeads(Grid& grid);
    void placeEntries(Grid& grid);
    void sortLists(Grid& grid);
    template <class Visit>
    void forEachEntry(const Grid& grid, Visit&& visit);

    Executor& executor_;
    std::vector<std::vector<Fragment>> fragments_; ///< per piece of the triangle loop
};

} // namespace dirt
