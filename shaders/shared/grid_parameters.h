// What the passes of construction and traversal need to know of the grid (std140).
#ifndef DIRT_SHARED_GRID_PARAMETERS_H
#define DIRT_SHARED_GRID_PARAMETERS_H

#include "shaders/shared/language.h"

DIRT_SHARED_BEGIN

struct GridParameters {
    ivec4 viewAxes[6]; // components of the grid frame that are x, y and w, and the sign of w
    int columns;       // tiles of a view; all views have the same
    int rows;
    int bins;
    int views;
    vec4 tilesOfSlope; // factors and offsets from slopes (x/w, y/w) to columns and rows
};

DIRT_SHARED_END

#ifdef __cplusplus

#include <cstddef>

namespace dirt {
static_assert(sizeof(GridParameters) == 128 && offsetof(GridParameters, columns) == 96 &&
              offsetof(GridParameters, tilesOfSlope) == 112);
} // namespace dirt

#endif

#endif
