#include "core/cost/cost_model.h"

#include <algorithm>
#include <initializer_list>

namespace dirt {

namespace {

// Nanoseconds of a thread: least squares over grids of tile 8 to 64 and 2 to 32 bins in three
// scenes, see docs/performance.md.
constexpr double kBuildEntry = 80.0;  ///< a list entry
constexpr double kBuildTile = 1700.0; ///< a tile, whatever it lists
constexpr double kRayTile = 7.6;      ///< a tile along a view, for a ray that walks over many
constexpr double kRayListed = 0.17;   ///< a triangle that the mean tile lists
constexpr double kRayBinned = 0.35;   ///< a triangle that the mean bin lists

} // namespace

GridCost gridCost(const Footprint& footprint, const GridSettings& grid) {
    const double entries = footprint.listEntries(grid), tiles = footprint.tiles(grid);
    return {kBuildEntry * entries + kBuildTile * tiles,
            kRayTile * footprint.tilesAcross(grid) + kRayListed * entries / tiles +
                kRayBinned * entries / (tiles * grid.bins)};
}

GridSettings chooseGrid(const Footprint& footprint, const RenderSettings& settings, bool chooseTile,
                        bool chooseBins) {
    const double rays = (double) settings.grid.width * settings.grid.height * settings.samples *
                        std::max(0, settings.bounces - 1);
    GridSettings best = settings.grid;
    double least = 0.0;
    bool first = true;
    for (const int tile : {8, 16, 32, 64})
        for (const int bins : {1, 2, 4, 8, 16, 32}) {
            GridSettings grid = settings.grid;
            if (chooseTile) grid.tile = tile;
            if (chooseBins) grid.bins = bins;
            const GridCost cost = gridCost(footprint, grid);
            const double frame = cost.build + rays * cost.ray;
            if (!first && frame >= least) continue;
            best = grid;
            least = frame;
            first = false;
        }
    return best;
}

} // namespace dirt
