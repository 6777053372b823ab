#pragma once

#include "core/cost/footprint.h"
#include "core/frame/settings.h"

namespace dirt {

/// What a grid costs, in nanoseconds of one thread of the machine of docs/performance.md. Only
/// differences between grids over the same scene mean anything: what every grid costs is left out.
struct GridCost {
    double build = 0.0; ///< of the construction
    double ray = 0.0;   ///< of a diffuse ray
};

/// The cost model; docs/performance.md says how its constants were measured. Construction pays for
/// each list entry and each tile; a diffuse ray for the tiles that it walks over, whose number
/// grows with the tiles along a view, and for the triangles that it looks at, more where tiles and
/// bins list many.
GridCost gridCost(const Footprint& footprint, const GridSettings& grid);

/// \p settings with the tile and bins of the lowest cost for a frame: its build, and the diffuse
/// rays of its samples and bounces. What is false of \p chooseTile and \p chooseBins stays. The
/// view size stays too: it matters through the tiles along a view alone.
GridSettings chooseGrid(const Footprint& footprint, const RenderSettings& settings, bool chooseTile,
                        bool chooseBins);

} // namespace dirt
