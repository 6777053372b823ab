#pragma once

#include "core/check/check_row.h"
#include "core/grid/grid.h"

#include <vector>

namespace dirt {

// Comparisons of one buffer each, which set the counts and examples of a row. \p ulps is what
// depths may be off; 0: nothing.

/// Triangle buffers, coordinate by coordinate.
void compareTriangles(const FrameGeometry& source, const FrameGeometry& tested, CheckRow& row);

/// Depth bounds at one level of the pyramids of all views.
void compareLevel(const Grid& source, const Grid& tested, size_t level, int ulps, CheckRow& row);

/// Lists in any order, entry by entry; what is listed twice is an entry in addition. \p geometry is
/// what both were built from.
void compareLists(const FrameGeometry& geometry, const Grid& source, const Grid& tested, int ulps,
                  CheckRow& row);

/// The triangles at the eye.
void compareAtEye(const Grid& source, const Grid& tested, CheckRow& row);

/// Shadow maps, texel by texel; \p resolution is that of a side. Depths may be off by err(t) where
/// arithmetic is not IEEE.
void compareShadowMaps(const std::vector<float>& source, const std::vector<float>& tested,
                       size_t resolution, bool isIeee, CheckRow& row);

} // namespace dirt
