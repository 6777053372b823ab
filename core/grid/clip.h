#pragma once

#include "core/grid/coverage.h"

namespace dirt {

/// Depths w, near <= far.
struct DepthInterval {
    float near = 0.0f;
    float far = 0.0f;
};

/// The exact clip of a triangle to a tile: its depths inside the guard-banded cone, rounded
/// outwards. Contains those inside the cone widened by 1/512 of a tile, and exceeds those inside
/// the cone widened by 1/64 by at most 16 ulp (G1, G2). False if nothing is left, which can only
/// happen where the part within 1/512 is empty.
bool clipToTile(const ViewTriangle& triangle, const View& view, int column, int row,
                DepthInterval& out);

} // namespace dirt
