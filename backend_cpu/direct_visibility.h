#pragma once

#include "core/frame/executor.h"
#include "core/frame/passes.h"

#include <span>

namespace dirt {

/// DirectVisibility: G[1] of every pixel, by rasterizing the triangle buffer from the eye, as
/// seen through the sample's sub-pixel offset. The points are those of traced primary rays, bit
/// for bit, equal depths included.
void rasterizeDirectVisibility(const FrameContext& frame, Executor& executor, uint32_t sample,
                               std::span<SurfacePoint> points);

/// The hits alone, without views and tiles.
void rasterizeHits(const FrameContext& frame, Executor& executor, uint32_t sample,
                   std::span<Hit> hits);

} // namespace dirt
