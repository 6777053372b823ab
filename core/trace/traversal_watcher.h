#pragma once

#include "core/trace/intersect.h"
#include "core/trace/view_walk.h"

#include <cstdint>
#include <span>

namespace dirt {

/// What became of a triangle that a ray tested, in the order in which it is asked.
enum class Tested {
    missed,  ///< by the decision of the precision
    known,   ///< it is the best hit already
    farther, ///< it is hit, but not nearer than the best hit, or than the ray is long
    outside, ///< it is hit outside the single view
    skipped, ///< the ray starts on it, or on one with the same vertices
    hole,    ///< it is cut out there, or has its back to the ray
    nearest  ///< the best hit so far; of a search for any hit: the one that ends it
};

/// Told what a traversal does, in its order: a view, its cells, a tile, its bins, their triangles.
class TraversalWatcher {
public:
    virtual ~TraversalWatcher() = default;

    /// The ray enters a view.
    virtual void view(const ViewSpan&) {}
    /// It looks at a cell of the view's pyramid.
    virtual void cell(const CellLook&) {}
    /// It visits a tile, from bin \p first to bin \p last.
    virtual void tile(const TileVisit&, int /*first*/, int /*last*/) {}
    /// It visits a bin of the tile, which lists \p ids.
    virtual void bin(int /*bin*/, std::span<const uint32_t> /*ids*/) {}
    /// It tests a triangle of the bin, or, before any view, one that holds the eye. \p hit is where
    /// the ray meets it, unless it was missed.
    virtual void test(uint32_t /*id*/, Tested, const TriangleHit& /*hit*/) {}
};

} // namespace dirt
