#pragma once

#include "core/base/executor.h"
#include "core/frame/settings.h"
#include "core/scene/camera.h"
#include "core/scene/scene.h"

#include <array>
#include <cstdint>
#include <vector>

namespace dirt {

class DepthMap;
struct SeenPolygon;

/// What a scene's triangles measure as the eye sees them: enough to say how many list entries a
/// grid of any tile and bins will have, without building it.
///
/// A convex body K in a grid of cells a x b x c at a random place meets on average as many cells as
/// K swept by one cell has of their volume: vol(K + cell) / abc. For a flat polygon this is
///
///     A_xy/ab + A_xz/ac + A_yz/bc + e_x/a + e_y/b + e_z/c + 1
///
/// of its shadows A on the coordinate planes and its extents e (the mixed volumes of Steiner's
/// formula; Schneider and Weil, Stochastic and Integral Geometry, 2008, chapter 5). Here x and y
/// are slopes in a view, z is depth, and a cell is a tile's bin: c is the tile's range of depths,
/// divided by the bins. So sums over the triangles, once, serve every grid.
class Footprint {
public:
    /// Measures all triangles from the camera's eye. \p grid: its views; tile and bins do not
    /// matter.
    Footprint(const Mesh& mesh, const Camera& camera, const GridSettings& grid, Executor& executor);

    /// Entries in all lists of the grid that \p grid describes; its views are those measured.
    double listEntries(const GridSettings& grid) const;

    /// Tiles of all views, and along the longer side of one.
    double tiles(const GridSettings& grid) const;
    double tilesAcross(const GridSettings& grid) const;

    /// Polygons that the triangles leave in the views.
    double polygons() const { return sums_.polygons; }

private:
    /// Depth ranges are known for views of 8, 16, 32, 64 and 128 tiles along the longer
    /// side.
    static constexpr int kFewestTiles = 8, kLevels = 5;

    /// Sums over polygons of what divides by a tile's depth range.
    struct DepthSums {
        double extent = 0.0;               ///< e_z / range, of polygons of about a tile or less
        double alongX = 0.0, alongY = 0.0; ///< A_xz / range, A_yz / range, of these
        double crossed = 0.0;              ///< of larger ones, tile by tile: depths / range

        void add(const SeenPolygon& polygon, const DepthMap& map);
    };

    /// Sums over the polygons that the triangles leave in the views.
    struct Sums {
        double polygons = 0.0;
        double area = 0.0; ///< A_xy
        double extentX = 0.0, extentY = 0.0;
        std::array<DepthSums, kLevels> depth; ///< [i]: of kFewestTiles * 2^i tiles a side

        void add(const Sums& other, double times);
    };

    int views_ = 0;
    int width_ = 0, height_ = 0;     ///< of a view, in pixels
    double rimX_ = 1.0, rimY_ = 1.0; ///< a view spans [-rim, rim]
    Sums sums_;
};

} // namespace dirt
