#pragma once

#include "core/grid/grid.h"

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace dirt {

/// A triangle in a tile: what the grid lists, beside what the rule of construction makes of it.
struct TileEntry {
    uint32_t id = 0;
    int view = 0, column = 0, row = 0;
    bool isDue = false;              ///< the overlap test and the clip say that the tile lists it
    DepthInterval depths{};          ///< of its part in the tile, where it is due
    std::vector<glm::dvec3> polygon; ///< of that part, in the view's frame (see clip_polygon.h)
    int firstBin = 0, lastBin = -1;  ///< in which it is due
    std::vector<int> bins;           ///< in which the grid has it

    /// Whether the grid has it where it is due and nowhere else.
    bool isRight() const;
};

/// All that a tile lists, or should list, in the order of ids.
std::vector<TileEntry> entriesOfTile(const Grid& grid, const FrameGeometry& geometry, int view,
                                     int column, int row);

/// All tiles that list a triangle, or should, in the order of views, rows and columns.
std::vector<TileEntry> entriesOfPrimitive(const Grid& grid, const FrameGeometry& geometry,
                                          uint32_t id);

} // namespace dirt
