#pragma once

#include "core/grid/grid.h"
#include "core/trace/ray.h"
#include "core/trace/traversal_watcher.h"

#include <cstdint>
#include <functional>

namespace dirt {

/// How much a traversal did.
struct TraversalCounts {
    uint64_t steps = 0; ///< cells of any pyramid level looked at
    uint64_t tiles = 0; ///< tiles whose bins were visited
    uint64_t bins = 0;  ///< bins visited
    uint64_t tests = 0; ///< ray-triangle tests
};

/// Nearest hit through the grid (T1–T7). Its view and tile are those whose visited interval holds
/// t, and which list the triangle; or the view after the last one, if only Grid::atEye lists it.
Hit closestHit(const Grid& grid, const FrameGeometry& geometry, const Ray& ray,
               TraversalCounts* counts = nullptr, TraversalWatcher* watcher = nullptr);

/// Whether anything is hit at t < maxT.
bool anyHit(const Grid& grid, const FrameGeometry& geometry, const Ray& ray, float maxT,
            TraversalCounts* counts = nullptr, TraversalWatcher* watcher = nullptr);

/// Calls \p visit(view, tile, bin) for each non-empty cell the ray visits, in the order of t, to
/// the ray's end: the visited set of T1.
void visitCells(const Grid& grid, const Ray& ray,
                const std::function<void(int view, int tile, int bin)>& visit);

/// Nearest hit by testing every triangle: the oracle.
Hit closestHitBruteForce(const FrameGeometry& geometry, const Ray& ray);

} // namespace dirt
