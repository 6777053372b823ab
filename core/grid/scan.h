#pragma once

#include "core/grid/clip.h"

namespace dirt {

/// Calls \p emit(tile, DepthInterval) for every tile of \p view that lists \p triangle. This is the
/// rule of FillDepth and FillPrimitives alike: a tile lists a triangle if the overlap test says so
/// and the clip leaves something, which gives the depths. Tiles that \p wanted(tile) refuses are
/// passed over.
template <class Wanted, class Emit>
void scanTriangle(const Triangle& triangle, const View& view, Wanted&& wanted, Emit&& emit) {
    ViewTriangle setup;
    if (!setUpTriangle(triangle, view, setup)) return;
    const TileRange range = tileRange(setup, view);
    DepthInterval depths;
    for (int row = range.row0; row <= range.row1; ++row)
        for (int column = range.column0; column <= range.column1; ++column) {
            const int tile = row * view.columns + column;
            if (wanted(tile) && !edgesSeparate(setup, view, column, row) &&
                clipToTile(setup, view, column, row, depths))
                emit(tile, depths);
        }
}

/// The same for all tiles.
template <class Emit>
void scanTriangle(const Triangle& triangle, const View& view, Emit&& emit) {
    scanTriangle(
        triangle, view, [](int) { return true; }, emit);
}

} // namespace dirt
