#pragma once

#include "backend_cpu/image/image_footprint.h"

#include <cstdint>
#include <optional>

namespace dirt {

/// The rays of an image's pixels, from the eye: what a triangle's numbers are made for.
struct EyeRays {
    float reach;  ///< bounds the |components| of their directions d
    float margin; ///< an edge's value nearer to zero decides nothing
    float spread; ///< bounds what the rounding of directions adds to an edge's value between pixels
    glm::dvec3 forward;
    double most; ///< bounds d . forward from above
};

/// A triangle as the pixels' rays see it.
///
/// With u = 2^-24, an edge's normal is a cross product of floats in double, one rounding a
/// component, scaled to a 1-norm of 1 and rounded to float; products and sums with d make its value
/// 4 u reach off, and `margin` is 6 u reach. 1/t of the plane is inverse . d: its normal is off by
/// 24 * 2^-53 length^2 in the 1-norm, the determinant by 48 * 2^-53 length^2 size; where that is
/// more than 2^-22 length^2 size, the first is a part of 2^-26.4, the second one of 2^-25.4, and
/// with the rounding to float and the evaluation, 4 u, all is below 8 u |inverse|_1 reach.
struct EyeTriangle {
    float edge[3][3]; ///< normals of the planes through the eye and an edge; inside is positive
    float inverse[3];
    float error; ///< of 1/t
    bool clear;  ///< else the eye may be in the plane: edges have no side, 1/t is not known
    uint32_t id;
    PixelRange range;
    float near; ///< bounds t from below

    EyeTriangle() = default;
    EyeTriangle(const Triangle& triangle, uint32_t id, const PixelRange& range,
                const EyeRays& rays);
    /// Whether no pixel between the four directions \p corners meets the triangle, certainly.
    bool misses(const glm::vec3 (&corners)[4], float spread) const;
};

} // namespace dirt
