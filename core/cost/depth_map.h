#pragma once

#include "core/cost/seen_polygon.h"

#include <atomic>
#include <cstdint>
#include <vector>

namespace dirt {

/// Depth ranges of one view's tiles, as polygons are laid into it; about what FillDepth finds.
class DepthMap {
public:
    /// A range of depths; empty as it is made.
    struct Range {
        float near = 3.4e38f, far = 0.0f;
        bool empty() const { return near > far; }
        double length() const { return empty() ? 0.0 : (double) far - near; }
    };
    /// Tiles over [-rimX, rimX] x [-rimY, rimY].
    DepthMap(int columns, int rows, double rimX, double rimY);

    /// Widens the ranges of the tiles that the polygon meets. From any thread.
    void include(const SeenPolygon& polygon);

    /// Whether the polygon's bounding box meets more than two tiles along a side.
    bool spansTiles(const SeenPolygon& polygon) const;
    /// Sum over the tiles that the polygon meets of its own range's length in the tile's.
    double rangesCrossed(const SeenPolygon& polygon) const;
    /// Mean of 1 / length of the ranges of the tiles that the polygon meets.
    double inverseLength(const SeenPolygon& polygon) const;

    /// The map of half as many columns and rows.
    DepthMap coarser() const;

private:
    /// Tiles [x0, x1] x [y0, y1].
    struct Box {
        int x0, y0, x1, y1;
    };
    /// Of a polygon's corners.
    struct Bounds {
        glm::dvec3 low, high;
    };
    Box boxOf(const SeenPolygon& polygon) const;
    bool meets(const SeenPolygon& polygon, int x, int y) const;
    /// Depths of the polygon in a tile, or a little more.
    Range depthsIn(const SeenPolygon& polygon, const Bounds& whole, int x, int y) const;
    /// Calls \p use(x, y, depths) for all tiles that the polygon meets.
    template <typename Use>
    void forTiles(const SeenPolygon& polygon, const Use& use) const;
    Range range(int x, int y) const;

    int columns_, rows_;
    double rimX_, rimY_;
    // Bits of positive floats, which compare as the numbers do.
    std::vector<std::atomic<uint32_t>> near_, far_;
};

} // namespace dirt
