#include "backend_cpu/builder.h"

#include "core/grid/scan.h"

#include <algorithm>
#include <atomic>

namespace dirt {
namespace {

constexpr size_t kTrianglesPerPiece = 1024;
constexpr size_t kTilesPerPiece = 256;

/// Minimum and maximum do not depend on the order, so neither do the bounds.
void includeAtomically(DepthBounds& bounds, float near, float far) {
    std::atomic_ref<float> sharedNear(bounds.near), sharedFar(bounds.far);
    float current = sharedNear.load(std::memory_order_relaxed);
    while (near < current &&
           !sharedNear.compare_exchange_weak(current, near, std::memory_order_relaxed)) {
    }
    current = sharedFar.load(std::memory_order_relaxed);
    while (far > current &&
           !sharedFar.compare_exchange_weak(current, far, std::memory_order_relaxed)) {
    }
}

/// The view that holds a tile of the numbering over all views.
int viewOf(const Grid& grid, uint32_t tile) {
    return (int) (std::upper_bound(grid.firstTile.begin(), grid.firstTile.end(), tile) -
                  grid.firstTile.begin()) -
           1;
}

} // namespace

void GridBuilder::fillDepth(const FrameGeometry& geometry, Grid& grid) {
    const size_t count = geometry.triangles.size();
    fragments_.resize((count + kTrianglesPerPiece - 1) / kTrianglesPerPiece);
    executor_.forRange(count, kTrianglesPerPiece, [&](size_t begin, size_t end) {
        std::vector<Fragment>& fragments = fragments_[begin / kTrianglesPerPiece];
        fragments.clear();
        for (size_t id = begin; id < end; ++id)
            for (size_t v = 0; v < grid.views.size(); ++v)
                scanTriangle(geometry.triangles[id], grid.views[v],
                             [&](int tile, DepthInterval depths) {
                                 includeAtomically(grid.pyramids[v].levels[0].bounds[tile],
                                                   depths.near, depths.far);
                                 fragments.push_back({grid.firstTile[v] + (uint32_t) tile,
                                                      (uint32_t) id, depths.near, depths.far});
                             });
    });
}

void GridBuilder::fillDepthMipmap(Grid& grid) {
    executor_.forRange(grid.pyramids.size(), 1,
                       [&](size_t view, size_t) { buildPyramid(grid.pyramids[view]); });
}

void GridBuilder::fillPrimitives(const FrameGeometry& geometry, Grid& grid) {
    grid.atEye = trianglesAtEye(geometry);
    countEntries(grid);
    sumHeads(grid);
    placeEntries(grid);
    sortLists(grid);
    fragments_ = {};
}

/// Calls visit(cell, id) for each list entry.
template <class Visit>
void GridBuilder::forEachEntry(const Grid& grid, Visit&& visit) {
    executor_.forRange(fragments_.size(), 1, [&](size_t piece, size_t) {
        for (const Fragment& fragment : fragments_[piece]) {
            const int view = viewOf(grid, fragment.tile);
            const int tile = (int) (fragment.tile - grid.firstTile[view]);
            const BinMap bin(grid.bounds(view, tile), grid.settings.bins);
            const size_t cell = grid.cell(view, tile, 0);
            for (int b = bin(fragment.near); b <= bin(fragment.far); ++b)
                visit(cell + b, fragment.id);
        }
    });
}

void GridBuilder::countEntries(Grid& grid) {
    grid.heads.assign((size_t) grid.firstTile.back() * grid.settings.bins + 1, 0);
    forEachEntry(grid, [&](size_t cell, uint32_t) {
        std::atomic_ref<uint32_t>(grid.heads[cell]).fetch_add(1, std::memory_order_relaxed);
    });
}

/// From counts to the end of each list.
void GridBuilder::sumHeads(Grid& grid) {
    uint64_t sum = 0;
    for (uint32_t& head : grid.heads) {
        sum += head;
        head = (uint32_t) sum;
    }
    checkEntryCount(sum);
    grid.ids.resize(sum);
}

/// Fills each list from its end, which leaves heads at the lists' beginnings.
void GridBuilder::placeEntries(Grid& grid) {
    forEachEntry(grid, [&](size_t cell, uint32_t id) {
        const uint32_t end =
            std::atomic_ref<uint32_t>(grid.heads[cell]).fetch_sub(1, std::memory_order_relaxed);
        grid.ids[end - 1] = id;
    });
}

/// Threads place entries in any order; the lists are kept in the order of ids (G6).
void GridBuilder::sortLists(Grid& grid) {
    const size_t bins = grid.settings.bins;
    executor_.forRange(grid.firstTile.back(), kTilesPerPiece, [&](size_t begin, size_t end) {
        for (size_t cell = begin * bins; cell < end * bins; ++cell)
            std::sort(grid.ids.begin() + grid.heads[cell], grid.ids.begin() + grid.heads[cell + 1]);
    });
}

} // namespace dirt
