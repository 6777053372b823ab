#pragma once

#include "backend_cpu/image/depth_lists.h"
#include "backend_cpu/image/eye_triangle.h"
#include "core/trace/ray.h"

#include <span>
#include <vector>

namespace dirt {

/// A tile of the image: its pixels' rays, and what they see so far.
struct EyeTile {
    static constexpr int kWidth = 32, kHeight = 16;
    static constexpr int kPixels = kWidth * kHeight;

    int x0, y0; ///< of its first pixel in the image
    alignas(64) float direction[3][kPixels];
    alignas(64) float low[kPixels];  ///< bounds of the 1/t of what is seen; infinite outside
    alignas(64) float high[kPixels]; ///< the image, -infinite where nothing is seen
    uint32_t id[kPixels];            ///< kNoPrimitive: nothing

    Ray ray(int pixel) const {
        return {glm::vec3(0.0f),
                {direction[0][pixel], direction[1][pixel], direction[2][pixel]},
                kNoPrimitive};
    }
};

/// Finds what the pixels of \p tile see of the triangles in \p list, which is in the order of
/// depth: the nearest hit by core's `intersect` that is there, at equal t the lowest id.
void rasterizeTile(const FrameGeometry& geometry, const std::vector<EyeTriangle>& items,
                   std::span<const DepthEntry> list, float margin, EyeTile& tile);

} // namespace dirt
