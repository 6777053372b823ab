#pragma once

#include "backend_cpu/image/eye_tile.h"
#include "core/base/executor.h"
#include "core/frame/passes.h"

#include <span>

namespace dirt {

/// What DirectVisibility works in, kept from sample to sample.
struct EyeBuffers {
    /// What one piece of the triangles gives.
    struct Piece {
        std::vector<EyeTriangle> items;
        std::vector<DepthFragment> fragments; ///< items counted from the piece's first
    };
    std::vector<Piece> pieces;
    std::vector<EyeTriangle> items;
    DepthLists lists; ///< of items, for each tile of the image
};

/// DirectVisibility: G[1] of every pixel, in \p paths, by rasterizing the triangle buffer from the
/// eye, as seen through the sample's sub-pixel offset. The points are those of traced primary rays,
/// bit for bit, equal depths included. Returns how many there are.
size_t rasterizeDirectVisibility(const FrameContext& frame, Executor& executor, uint32_t sample,
                                 EyeBuffers& buffers, PathBuffers& paths);

/// The hits alone, without views and tiles.
void rasterizeHits(const FrameContext& frame, Executor& executor, uint32_t sample,
                   EyeBuffers& buffers, std::span<Hit> hits);

} // namespace dirt
