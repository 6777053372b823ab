#pragma once

#include "core/grid/view.h"

#include <array>

#include <glm/vec3.hpp>

namespace dirt {

/// A triangle made ready for one view: what the overlap test and the clip need of it.
struct ViewTriangle {
    /// The triangle's vertices in the view's frame (x, y, w).
    std::array<glm::vec3, 3> vertices;
    /// The triangle's directions clipped at w >= 0: at most four, each scaled by a power of two.
    std::array<glm::vec3, 4> directions;
    int directionCount = 0;
    /// Normals of the planes through the eye and an edge (ab, bc, ca), each scaled by a power of
    /// two, pointing inwards unless the triangle is edge-on.
    std::array<glm::vec3, 3> edges;
    /// The same as cross products, unscaled: each component is exact but for one rounding.
    std::array<glm::dvec3, 3> normals;
    /// a . (b × c): relative error at most 2.5 * 2^-27, exact sign.
    double determinant = 0.0;
    /// The eye lies in the triangle's plane, or there is no plane.
    bool edgeOn() const { return determinant == 0.0; }
};

/// Tiles [column0, column1] x [row0, row1]; empty if column0 > column1 or row0 > row1.
struct TileRange {
    int column0 = 0, column1 = -1;
    int row0 = 0, row1 = -1;
    bool empty() const { return column0 > column1 || row0 > row1; }
};

/// Sets up \p triangle (in the grid frame) for \p view. False if nothing of it has w > 0.
bool setUpTriangle(const Triangle& triangle, const View& view, ViewTriangle& out);

/// The tiles that the side planes alone do not separate from the triangle.
TileRange tileRange(const ViewTriangle& triangle, const View& view);

/// Whether an edge plane of the triangle separates it from the guard-banded tile.
bool edgesSeparate(const ViewTriangle& triangle, const View& view, int column, int row);

/// The overlap test (G1, G2): true for every tile whose cone, widened by 1/512 of a tile, meets
/// the triangle; false for every tile whose cone, widened by 1/64, does not. The same bits on
/// every device.
bool overlaps(const ViewTriangle& triangle, const View& view, int column, int row);

} // namespace dirt
