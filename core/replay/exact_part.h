#pragma once

#include "core/grid/view.h"
#include "core/verify/exact_clip.h"

namespace dirt {

/// The depths of a triangle's part within \p widened of a tile around the tile, exactly.
inline ExactDepths exactPart(const Triangle& triangle, const View& view, int tilePixels,
                             uint32_t tile, double widened) {
    const int column = (int) tile % view.columns, row = (int) tile / view.columns;
    return clipExactly(ExactTriangle(triangle, view),
                       ExactCone(view, column, row, tileSize(view, tilePixels), widened));
}

/// \p x moved by \p ulps floats, up or down.
inline float movedBy(float x, int ulps) {
    for (; ulps > 0; --ulps) x = std::nextafter(x, INFINITY);
    for (; ulps < 0; ++ulps) x = std::nextafter(x, -INFINITY);
    return x;
}

} // namespace dirt
