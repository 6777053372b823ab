#pragma once

#include "core/frame/settings.h"
#include "core/grid/geometry.h"

#include <cstdint>

#include <glm/vec2.hpp>

namespace dirt {

/// Decides by exact arithmetic whether rasterization may see another triangle through a pixel than
/// the exact ray does.
///
/// Rasterizers move vertices to a raster of 1/256 of a pixel, by 1/512 along each axis and so by
/// less than 1/362; transform and clipping add what float rounds, below 1/1000 of a pixel at any
/// size that fits 16 bits. An edge of a triangle, and the line in which two triangles meet, moves
/// by no more: 1/128 of a pixel, with a margin of two.
class VisibilityJudge {
public:
    /// \p geometry must outlive the judge. \p offset is the sample's sub-pixel offset.
    VisibilityJudge(const FrameGeometry& geometry, const Camera& camera,
                    const GridSettings& settings, glm::vec2 offset);

    /// Whether \p a and \p b (ids, one of them may be kNoPrimitive) may be mistaken for each other
    /// in \p pixel: its sample lies within 1/128 of a pixel of an edge of one of them, or of points
    /// in which both, hit by the sample's ray, are equally far.
    bool mayConfuse(size_t pixel, uint32_t a, uint32_t b) const;

private:
    const FrameGeometry& geometry_;
    Camera camera_;
    GridSettings settings_;
    glm::vec2 offset_;
};

} // namespace dirt
