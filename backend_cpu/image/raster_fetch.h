#pragma once

#include "backend_cpu/build/fragments.h"
#include "backend_cpu/build/raster_tables.h"
#include "core/base/executor.h"
#include "core/frame/passes.h"
#include "core/grid/grid.h"

#include <cstdint>
#include <vector>

namespace dirt {

/// What a hit record lists for Fetch.
struct HitEntry {
    uint32_t primitive;
    uint32_t tile; ///< over all views; the eye is one more after them
    uint32_t pixel;
};

/// What Fetch works in, kept from event to event.
struct FetchBuffers {
    /// The records of one piece of the pixels.
    struct Piece {
        std::vector<HitEntry> fragments;
    };
    RasterTables tables;
    std::vector<Piece> pieces;
    FragmentBuckets<HitEntry, &HitEntry::primitive> buckets;
    std::vector<uint32_t> pixels; ///< owners of the records that were found, by primitive
};

/// Fetch as the paper has it: rasterizes the triangles that records name with the coverage of
/// FillPrimitives, and writes G[k+1] of the owner of each record that is listed in a tile where its
/// triangle is. The same bits as the fetch by primitive id.
void rasterFetch(const FrameContext& frame, const Grid& grid, Executor& executor,
                 FetchBuffers& buffers, PathBuffers& paths);

} // namespace dirt
