#pragma once

#include "backend_cpu/image/image_cull.h"
#include "core/grid/geometry.h"

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>

namespace dirt {

/// Pixels [x0, x1] x [y0, y1]; empty if x0 > x1 or y0 > y1.
struct PixelRange {
    int x0 = 0, x1 = -1;
    int y0 = 0, y1 = -1;
};

/// Which pixels of the image a triangle may cover: the first, conservative step of rasterization.
class ImageFootprint {
public:
    /// \p offset is the sample's, in [0, 1)^2 of a pixel.
    ImageFootprint(const Camera& camera, int width, int height, ViewMode mode, glm::vec2 offset);

    /// At least the pixels whose camera ray meets the closed triangle.
    PixelRange operator()(const Triangle& triangle) const;

    /// For the choice of those triangles that are worth to be asked for.
    ImageCull cull() const;

private:
    glm::dmat3 toImage_;        ///< grid frame to (x, y, z): slopes are x/z, y/z
    glm::dvec2 slope_;          ///< at pixel (0, 0)
    glm::dvec2 step_;           ///< per pixel
    glm::dvec2 offset_;         ///< of the sample, pixels
    double largestSlope_ = 0.0; ///< of the image, and 1
    double margin_ = 0.0;       ///< of a slope
    glm::dvec2 first_, last_;   ///< slopes of the first and last pixels' rays, a margin beside
    glm::ivec2 size_;
};

} // namespace dirt
