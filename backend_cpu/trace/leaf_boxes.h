#pragma once

#include "core/grid/grid.h"

#include <glm/vec3.hpp>

namespace dirt {

/// An axis-aligned box in the grid frame.
struct LeafBox {
    glm::vec3 low, high;

    void include(const LeafBox& box);
};

/// Box of the points of one cell that a ray may be found to hit there: those of the tile's cone
/// widened by 1/512 at the depths of the bin.
LeafBox boxOfCell(const Grid& grid, int view, int tile, int bin);

} // namespace dirt
