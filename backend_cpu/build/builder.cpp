#include "backend_cpu/build/builder.h"

#include "backend_cpu/build/list_bins.h"
#include "backend_cpu/build/rasterizer.h"

#include <algorithm>
#include <numeric>

namespace dirt {
namespace {

/// Calls visit(fragment, first cell, last cell), cells counted from the first of the bucket: in
/// the order of ids, or in the opposite one.
template <bool Backwards, class Visit>
void forEachFragment(std::span<const Fragment> fragments, uint32_t firstTile, int bins,
                     const BinMaps& maps, Visit&& visit) {
    uint32_t first[kFragmentsAtOnce], last[kFragmentsAtOnce];
    for (size_t done = 0; done < fragments.size(); done += kFragmentsAtOnce) {
        const size_t count = std::min(kFragmentsAtOnce, fragments.size() - done);
        const size_t begin = Backwards ? fragments.size() - done - count : done;
        const std::span<const Fragment> some = fragments.subspan(begin, count);
        findCells(some, firstTile, bins, maps, first, last);
        for (size_t i = 0; i < count; ++i) {
            const size_t at = Backwards ? count - 1 - i : i;
            visit(some[at], first[at], last[at]);
        }
    }
}

} // namespace

void GridBuilder::fillDepth(const FrameGeometry& geometry, Grid& grid) {
    tables_.set(grid);
    const size_t count = geometry.triangles.size();
    pieces_.resize((count + kTrianglesPerPiece - 1) / kTrianglesPerPiece);
    executor_.forRange(count, kTrianglesPerPiece, [&](size_t begin, size_t end) {
        rasterize(geometry, grid, tables_, begin, end, pieces_[begin / kTrianglesPerPiece]);
    });
    buckets_.fill(pieces_, grid.firstTile.back(), executor_);

    executor_.forRange(buckets_.count(), 1, [&](size_t bucket, size_t) {
        thread_local std::vector<DepthBounds> bounds;
        const uint32_t firstTile = buckets_.firstTile(bucket), tiles = buckets_.tiles(bucket);
        bounds.assign(tiles, {});
        for (const Fragment& fragment : buckets_[bucket])
            bounds[fragment.tile - firstTile].include(fragment.near, fragment.far);
        int view = 0;
        for (uint32_t i = 0; i < tiles; ++i) {
            const uint32_t tile = firstTile + i;
            while (tile >= grid.firstTile[view + 1]) ++view;
            grid.pyramids[view].levels[0].bounds[tile - grid.firstTile[view]] = bounds[i];
        }
    });
}

void GridBuilder::fillDepthMipmap(Grid& grid) {
    executor_.forRange(grid.pyramids.size(), 1,
                       [&](size_t view, size_t) { buildPyramid(grid.pyramids[view]); });
}

void GridBuilder::fillPrimitives(Grid& grid) {
    grid.atEye.clear();
    for (const RasterPiece& piece : pieces_)
        grid.atEye.insert(grid.atEye.end(), piece.atEye.begin(), piece.atEye.end());
    countEntries(grid);
    placeEntries(grid);
}

uint64_t GridBuilder::bytes() const {
    uint64_t bytes = buckets_.bytes();
    for (const RasterPiece& piece : pieces_) bytes += piece.fragments.capacity() * sizeof(Fragment);
    return bytes;
}

/// Leaves in heads where each list ends, counted from the first entry of its bucket.
void GridBuilder::countEntries(Grid& grid) {
    const int bins = grid.settings.bins;
    grid.heads.resize((size_t) grid.firstTile.back() * bins + 1);
    entries_.resize(buckets_.count() + 1);
    executor_.forRange(buckets_.count(), 1, [&](size_t bucket, size_t) {
        thread_local BinMaps maps;
        const uint32_t firstTile = buckets_.firstTile(bucket), tiles = buckets_.tiles(bucket);
        maps.set(grid, firstTile, tiles);
        uint32_t* heads = grid.heads.data() + (size_t) firstTile * bins;
        std::fill_n(heads, (size_t) tiles * bins, 0);
        forEachFragment<false>(buckets_[bucket], firstTile, bins, maps,
                               [&](const Fragment&, uint32_t first, uint32_t last) {
                                   for (uint32_t cell = first; cell <= last; ++cell) ++heads[cell];
                               });
        uint64_t sum = 0;
        for (size_t cell = 0; cell < (size_t) tiles * bins; ++cell)
            heads[cell] = (uint32_t) (sum += heads[cell]);
        entries_[bucket] = sum;
    });
    entries_.back() = 0;
    std::exclusive_scan(entries_.begin(), entries_.end(), entries_.begin(), uint64_t(0));
    checkEntryCount(entries_.back());
}

/// Fills each list from its end, which leaves heads at the lists' beginnings and ids in order.
void GridBuilder::placeEntries(Grid& grid) {
    const int bins = grid.settings.bins;
    grid.heads.back() = (uint32_t) entries_.back();
    grid.ids.resize(entries_.back());
    executor_.forRange(buckets_.count(), 1, [&](size_t bucket, size_t) {
        thread_local BinMaps maps;
        const uint32_t firstTile = buckets_.firstTile(bucket), tiles = buckets_.tiles(bucket);
        maps.set(grid, firstTile, tiles);
        uint32_t* heads = grid.heads.data() + (size_t) firstTile * bins;
        uint32_t* ids = grid.ids.data() + entries_[bucket];
        forEachFragment<true>(buckets_[bucket], firstTile, bins, maps,
                              [&](const Fragment& fragment, uint32_t first, uint32_t last) {
                                  for (uint32_t cell = first; cell <= last; ++cell)
                                      ids[--heads[cell]] = fragment.id;
                              });
        const uint32_t base = (uint32_t) entries_[bucket];
        for (size_t cell = 0; cell < (size_t) tiles * bins; ++cell) heads[cell] += base;
    });
}

} // namespace dirt
