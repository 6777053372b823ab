#include "backend_cpu/light/light_grid.h"

#include "backend_cpu/light/light_cone.h"
#include "backend_cpu/light/light_raster.h"
#include "shaders/shared/margins.h"

#include <algorithm>
#include <cmath>

namespace dirt {
namespace {

constexpr size_t kScannedPerPiece = 1024;

/// More triangles than this beside the light, which every ray tests, are no gain.
constexpr size_t kMostClose = 16;

/// Each bucket of tiles is some thread's: their heads, and their lists.
void fillLists(Executor& executor, LightGrid& grid) {
    const uint32_t tiles = grid.tree.tiles;
    grid.buckets.fill(grid.pieces, tiles, executor);
    const size_t entries = grid.buckets.before(grid.buckets.count());
    grid.heads.resize(tiles + 1);
    grid.heads.back() = (uint32_t) entries;
    grid.near.resize(entries + LightGrid::kPadding);
    grid.box.resize(entries + LightGrid::kPadding);
    grid.id.resize(entries);
    executor.forRange(grid.buckets.count(), 1, [&](size_t bucket, size_t) {
        const uint32_t firstTile = grid.buckets.firstTile(bucket);
        const uint32_t count = grid.buckets.tiles(bucket);
        const std::span<const LightFragment> fragments = grid.buckets[bucket];
        uint32_t* const heads = grid.heads.data() + firstTile;
        std::fill_n(heads, count, 0);
        for (const LightFragment& fragment : fragments) ++heads[fragment.tile - firstTile];
        uint32_t sum = (uint32_t) grid.buckets.before(bucket);
        for (uint32_t tile = 0; tile < count; ++tile) heads[tile] = sum += heads[tile];
        // Each list is filled from its end, which leaves heads at the beginnings, ids in order.
        for (size_t i = fragments.size(); i-- > 0;) {
            const LightFragment& fragment = fragments[i];
            const uint32_t at = --heads[fragment.tile - firstTile];
            grid.near[at] = fragment.near;
            grid.box[at] = fragment.box;
            grid.id[at] = fragment.id;
        }
    });
}

} // namespace

uint64_t LightGrid::bytes() const {
    return (tree.nodes.size() + heads.size()) * sizeof(uint32_t) + near.size() * sizeof(float) +
           (box.size() + id.size()) * sizeof(uint32_t) + records.size() * sizeof(LightRecord);
}

uint64_t LightGrid::pieceBytes() const {
    uint64_t bytes = buckets.bytes();
    for (const LightPiece& piece : pieces)
        bytes += piece.fragments.capacity() * sizeof(LightFragment);
    return bytes;
}

void fillLightGrid(const FrameGeometry& geometry, const Spotlight& light, Executor& executor,
                   LightGrid& grid) {
    grid.tree.tiles = 0;
    const size_t count = geometry.triangles.size();
    grid.position = geometry.frame.toGrid(light.position);
    // Origins lie within the scene, whose coordinates are below 2, or a rounding beside it.
    grid.reach = 2.5f + std::max({std::abs(grid.position.x), std::abs(grid.position.y),
                                  std::abs(grid.position.z)});
    if (!(grid.reach < 0x1p20f)) return;
    const LightCone cone(light, geometry.frame);
    grid.nearest = kLightNearest * grid.reach;
    makeLightTree(geometry, grid.position, cone, executor, grid.tree);

    grid.records.resize(count);
    grid.pieces.resize((count + kScannedPerPiece - 1) / kScannedPerPiece);
    executor.forRange(count, kScannedPerPiece, [&](size_t begin, size_t end) {
        scanFromLight(geometry, grid, begin, end, grid.pieces[begin / kScannedPerPiece]);
    });
    grid.close.clear();
    for (const LightPiece& piece : grid.pieces)
        grid.close.insert(grid.close.end(), piece.close.begin(), piece.close.end());
    if (grid.close.size() > kMostClose)
        grid.tree.tiles = 0;
    else
        fillLists(executor, grid);
}

} // namespace dirt
