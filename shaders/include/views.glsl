// The views and their tiles, as core/grid/view.h makes them.

#include "shared/grid_parameters.h"

layout(std140, binding = 0) uniform GridBlock {
    GridParameters grid;
};

/// Guard-banded borders (lo, hi): of each column, then of each row.
layout(binding = 0) uniform samplerBuffer borders;

vec2 columnBorders(int column) {
    return texelFetch(borders, column).xy;
}
vec2 rowBorders(int row) {
    return texelFetch(borders, grid.columns + row).xy;
}

/// (x, y, w) of a point of the grid frame.
vec3 toView(int view, vec3 p) {
    ivec4 axes = grid.viewAxes[view];
    return vec3(p[axes.x], p[axes.y], axes.w < 0 ? -p[axes.z] : p[axes.z]);
}
