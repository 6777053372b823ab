#pragma once

#include "core/frame/executor.h"
#include "core/frame/passes.h"
#include "core/grid/grid.h"

namespace dirt {

/// Fetch as the paper has it: rasterizes the triangles with the coverage of FillPrimitives against
/// the hit records that each tile lists, and writes G[k+1] of the owner of each record that names
/// the triangle. The same bits as the fetch by primitive id.
void rasterFetch(const FrameContext& frame, const Grid& grid, Executor& executor,
                 PathBuffers& paths);

} // namespace dirt
