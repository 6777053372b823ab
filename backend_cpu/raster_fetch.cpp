#include "backend_cpu/raster_fetch.h"

#include "core/grid/scan.h"
#include "core/path/surface.h"

#include <algorithm>
#include <vector>

namespace dirt {
namespace {

constexpr size_t kTrianglesPerPiece = 1024;
constexpr size_t kTilesPerPiece = 16;
constexpr size_t kPixelsPerPiece = 4096;

/// The hit records of each tile of the numbering over all views, in the order of primitives; the
/// eye is one more tile after them.
class HitLists {
public:
    HitLists(const Grid& grid, Executor& executor, const std::vector<Hit>& hits)
        : grid_(grid), hits_(hits), heads_((size_t) grid.firstTile.back() + 2, 0) {
        for (const Hit& hit : hits)
            if (hit.found()) ++heads_[tileOf(hit)];
        uint32_t sum = 0;
        for (uint32_t& head : heads_) head = sum += head;
        pixels_.resize(sum);
        for (uint32_t pixel = (uint32_t) hits.size(); pixel-- > 0;)
            if (hits[pixel].found()) pixels_[--heads_[tileOf(hits[pixel])]] = pixel;
        executor.forRange(heads_.size() - 1, kTilesPerPiece, [&](size_t begin, size_t end) {
            for (size_t tile = begin; tile < end; ++tile)
                std::sort(
                    pixels_.begin() + heads_[tile], pixels_.begin() + heads_[tile + 1],
                    [&](uint32_t a, uint32_t b) { return hits[a].primitive < hits[b].primitive; });
        });
    }

    bool empty(size_t tile) const { return heads_[tile] == heads_[tile + 1]; }

    /// Calls \p visit(pixel) for the records in \p tile that name \p primitive.
    template <typename Visit>
    void forEach(size_t tile, uint32_t primitive, const Visit& visit) const {
        const auto end = pixels_.begin() + heads_[tile + 1];
        auto it = std::lower_bound(
            pixels_.begin() + heads_[tile], end, primitive,
            [&](uint32_t pixel, uint32_t id) { return hits_[pixel].primitive < id; });
        for (; it != end && hits_[*it].primitive == primitive; ++it) visit(*it);
    }

    size_t eye() const { return grid_.firstTile.back(); }

private:
    size_t tileOf(const Hit& hit) const {
        return hit.view < grid_.views.size() ? (size_t) grid_.firstTile[hit.view] + hit.tile
                                             : eye();
    }

    const Grid& grid_;
    const std::vector<Hit>& hits_;
    std::vector<uint32_t> heads_;  ///< tiles, the eye, and the end
    std::vector<uint32_t> pixels_; ///< owners
};

} // namespace

void rasterFetch(const FrameContext& frame, const Grid& grid, Executor& executor,
                 PathBuffers& paths) {
    executor.forRange(paths.pixels(), kPixelsPerPiece, [&](size_t begin, size_t end) {
        for (size_t pixel = begin; pixel < end; ++pixel) paths.clearNext(pixel);
    });
    const HitLists lists(grid, executor, paths.hits);
    const auto fetch = [&](size_t tile, uint32_t id) {
        lists.forEach(tile, id, [&](uint32_t pixel) {
            Hit& hit = paths.hits[pixel];
            paths.setNext(pixel,
                          fetchSurface(frame.scene, frame.geometry, paths.rays[pixel].direction, id,
                                       hit.u, hit.v),
                          frame.geometry);
            ++hit.fetches;
        });
    };
    const auto& triangles = frame.geometry.triangles;
    executor.forRange(triangles.size(), kTrianglesPerPiece, [&](size_t begin, size_t end) {
        for (size_t id = begin; id < end; ++id)
            for (size_t v = 0; v < grid.views.size(); ++v) {
                const size_t first = grid.firstTile[v];
                scanTriangle(
                    triangles[id], grid.views[v],
                    [&](int tile) { return !lists.empty(first + (size_t) tile); },
                    [&](int tile, DepthInterval) { fetch(first + (size_t) tile, (uint32_t) id); });
            }
    });
    for (uint32_t id : grid.atEye) fetch(lists.eye(), id);
}

} // namespace dirt
