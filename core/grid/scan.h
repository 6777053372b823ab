#pragma once

#include "core/grid/clip.h"

namespace dirt {

/// Calls \p emit(tile, DepthInterval) for every tile of \p view that lists \p triangle. This is the
/// rule of FillDepth and FillPrimitives alike: a tile lists a triangle if the overlap test says so
/// and the clip leaves something, which gives the depths.
template <class Emit>
void scanTriangle(const Triangle& triangle, const View& view, Emit&& emit) {
    ViewTriangle setup;
    if (!setUpTriangle(triangle, view, setup)) return;
    const TileRange range = tileRange(setup, view);
    DepthInterval depths;
    for (int row = range.row0; row <= range.row1; ++row)
        for (int column = range.column0; column <= range.column1; ++column)
            if (!edgesSeparate(setup, view, column, row) &&
                clipToTile(setup, view, column, row, depths))
                emit(row * view.columns + column, depths);
}

} // namespace dirt
