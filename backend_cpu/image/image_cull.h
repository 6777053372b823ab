#pragma once

#include "core/grid/geometry.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace dirt {

/// The image as the SIMD form of the footprint reads it.
struct ImageCull {
    float toImage[3][3]; ///< rows: grid frame to (x, y, z)
    /// Of the columns' and the rows' direction, in pixels:
    float perSlope[2], middle[2]; ///< place of a slope
    float margin[2];              ///< of a place, for rays and rounding; and of what
    float marginPerSlope[2];      ///< rounding adds for a vertex far from the axis
    float last[2];                ///< pixel
};

/// Room that keepInImage needs beyond the triangles.
inline constexpr size_t kKeptPadding = 16;

/// Writes to \p kept which of \p triangles may cover pixels, increasing: all that a pixel's camera
/// ray meets, and few that lie beside the image, behind the eye or between pixels' centres. Returns
/// how many.
size_t keepInImage(const ImageCull& image, std::span<const Triangle> triangles, uint32_t* kept);

} // namespace dirt
