#pragma once

#include "core/grid/grid.h"
#include "core/probe/cell.h"
#include "core/trace/ray.h"

#include <limits>
#include <string>
#include <vector>

namespace dirt {

/// A triangle in world space.
struct WorldTriangle {
    glm::vec3 a, b, c;
};

/// Depths along a view's axis in world units, near <= far; empty where nothing is.
struct WorldDepths {
    float near = 0.0f, far = -1.0f;
    bool empty() const { return near > far; }
    bool operator==(const WorldDepths&) const = default;
};

/// Primitive ids in increasing order.
using Ids = std::vector<uint32_t>;

/// Answers questions about the contents of a grid, in world space, for unit tests: what is listed
/// where, and what a ray meets. Points, directions and depths go through the grid frame's own
/// rounding to float first. What is asked of a tile, cell or id that does not exist throws
/// std::out_of_range, which says what there is. See docs/unit-testing.md.
class GridProbe {
public:
    /// The grid that core's definition builds. A triangle's index is its id. Throws InputError
    /// where there are none, or a number is none that a grid can be made of.
    GridProbe(const std::vector<WorldTriangle>& triangles, const Camera& camera,
              const GridSettings& settings);

    /// A grid that was built by anything, over \p geometry.
    GridProbe(FrameGeometry geometry, Grid grid);

    const Grid& grid() const { return grid_; }
    const FrameGeometry& geometry() const { return geometry_; }

    // Where something is.

    /// The tiles whose closed cones hold a point: several on a border, none at the eye or, in
    /// single mode, outside of the view.
    std::vector<Tile> tilesAt(glm::vec3 point) const;
    /// The tiles that are seen from the eye in a direction.
    std::vector<Tile> tilesAlong(glm::vec3 direction) const;
    /// The bins of a tile that hold depths from \p near to \p far: none beyond its depth bounds.
    std::vector<int> binsBetween(const Tile& tile, float near, float far) const;
    /// The cells that hold a point.
    std::vector<Cell> cellsAt(glm::vec3 point) const;

    // What is there.

    /// The nearest and farthest depth of what the tile lists.
    WorldDepths depths(const Tile& tile) const;
    /// What a cell lists.
    Ids ids(const Cell& cell) const;
    /// What a tile lists in any of its bins.
    Ids ids(const Tile& tile) const;
    /// All cells that list a triangle, in increasing order.
    std::vector<Cell> cellsOf(uint32_t id) const;

    // What a ray meets: origin + t direction, t >= 0.

    /// The non-empty cells that the ray visits, in the order of t.
    std::vector<Cell> visited(glm::vec3 origin, glm::vec3 direction) const;
    /// The nearest hit through the grid at t < \p tMax, in units of \p direction. The triangle
    /// \p skip, from which the ray starts, is not hit, nor is one with the same corners.
    Hit hit(glm::vec3 origin, glm::vec3 direction, uint32_t skip = kNoPrimitive,
            float tMax = std::numeric_limits<float>::infinity()) const;

    // What to print when a test fails.

    /// A tile with its depths, and each bin with its depths and ids.
    std::string describe(const Tile& tile) const;
    std::string describe(const Cell& cell) const { return describe(cell.tile()); }
    /// The sizes, and all tiles that list anything.
    std::string describe() const;

    /// The ray in the grid frame, its t unchanged: for the functions of core/trace.
    Ray gridRay(glm::vec3 origin, glm::vec3 direction, uint32_t skip = kNoPrimitive) const;

private:
    void checkId(uint32_t id) const;
    std::vector<Tile> tilesOfGridPoint(glm::vec3 point) const;
    int indexOf(const Tile& tile) const;
    Cell cellOf(int view, int tile, int bin) const;
    std::string viewName(int view) const;

    FrameGeometry geometry_;
    Grid grid_;
};

} // namespace dirt
