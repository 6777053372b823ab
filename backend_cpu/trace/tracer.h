#pragma once

#include "backend_cpu/light/light_grid.h"
#include "backend_cpu/trace/leaves.h"
#include "core/trace/traverse.h"
#include "core/trace/view_cone.h"

#include <optional>
#include <span>
#include <vector>

namespace dirt {

/// What the traversal of the leaves did.
struct LeafCounts {
    uint64_t steps = 0;     ///< tiles looked at
    uint64_t tiles = 0;     ///< tiles whose lists were visited
    uint64_t nodes = 0;     ///< nodes tested
    uint64_t blocks = 0;    ///< blocks tested, and
    uint64_t triangles = 0; ///< triangles whose boxes there are met
    uint64_t exact = 0;     ///< triangles that went on to core's exact decision
    uint64_t scalar = 0;    ///< rays left to core's traversal
    uint64_t lookups = 0;   ///< shadow rays answered by the light grid, and
    uint64_t listed = 0;    ///< triangles looked at there
};

inline constexpr int kMaxViews = 6;

/// One view as the walk needs it. Of two numbers the first is for columns, the second for rows.
struct TracedView {
    int tiles[2];
    const float* borders[2];
    double tilesPerSlope[2];
    const TileDepths* depths;
};

/// What all views' cones are made of, one lane a view; lanes without a view are never met.
struct ViewTable {
    static constexpr int kLanes = 8;
    int axis[3][kLanes] = {};             ///< components of x, y and w in the grid frame,
    double sign[3][kLanes] = {};          ///< with their signs
    alignas(64) double rim[2][2][kLanes]; ///< slopes: column or row, low and high
    alignas(64) double atLeast[kLanes];   ///< a part that ends there or before is left out
    alignas(64) double nearest[kLanes];   ///< least w of a ray that is walked, by its distance
};

/// Traces rays through the leaves of a grid: the hits of core's traversal, to the bit.
class LeafTracer {
public:
    /// All arguments must stay alive and unchanged while rays are traced. \p light, if any, answers
    /// for the rays that end in its point.
    LeafTracer(const FrameGeometry& geometry, const Grid& grid, const Leaves& leaves,
               const LightGrid* light = nullptr);

    /// Nearest hits, as core's closestHit. \p counts, if any, gets what was done added.
    void closest(std::span<const Ray> rays, std::span<Hit> hits,
                 LeafCounts* counts = nullptr) const;
    /// 1 where anything is hit at t < maxT, as core's anyHit.
    void occluded(std::span<const Ray> rays, std::span<const float> maxT, std::span<uint8_t> result,
                  LeafCounts* counts = nullptr) const;

    const FrameGeometry& geometry;
    const Grid& grid;
    const Leaves& leaves;
    const LightGrid* light;
    std::vector<TracedView> views;
    ViewTable viewTable;
    std::optional<ViewCone> cone; ///< single mode: where rays end
};

} // namespace dirt
