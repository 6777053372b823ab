#pragma once

#include "backend_cpu/build/fragments.h"
#include "backend_cpu/build/raster_tables.h"
#include "core/base/executor.h"
#include "core/grid/grid.h"

#include <vector>

namespace dirt {

/// The construction passes, in SIMD and spread over an Executor. Each gives the bits of buildGrid
/// (core), which is its oracle, for any number of threads. Keeps its memory from frame to frame.
class GridBuilder {
public:
    explicit GridBuilder(Executor& executor) : executor_(executor) {}

    /// Depth bounds of every tile; keeps the fragments for fillPrimitives.
    void fillDepth(const FrameGeometry& geometry, Grid& grid);
    /// Depth pyramid of every view.
    void fillDepthMipmap(Grid& grid);
    /// The id buffer, from the fragments of fillDepth and the depth bounds in \p grid.
    void fillPrimitives(Grid& grid);

    /// What it keeps between the passes, and from frame to frame.
    uint64_t bytes() const;

private:
    void countEntries(Grid& grid);
    void placeEntries(Grid& grid);

    Executor& executor_;
    RasterTables tables_;
    std::vector<RasterPiece> pieces_;
    FragmentBuckets<Fragment> buckets_;
    std::vector<uint64_t> entries_; ///< before each bucket
};

} // namespace dirt
