#include "backend_cpu/light_grid.h"

#include "backend_cpu/light_cone.h"
#include "backend_cpu/light_raster.h"

#include <algorithm>
#include <cmath>

namespace dirt {
namespace {

constexpr size_t kTrianglesPerPiece = 1024;

/// Tiles in the light's cone for each triangle of the scene: fewer make lists long, more cost time
/// to fill.
constexpr double kTilesPerTriangle = 1.0 / 32.0;
constexpr int kLeastTiles = 16, kMostTiles = 4096;

/// More triangles than this beside the light, which every ray tests, are no gain.
constexpr size_t kMostClose = 16;

// Where a ray is looked up. u = 2^-24, n tiles along a face, of width 2/n; a unit is a 128th of a
// tile. p = o - L is the ray's origin seen from the light, |p| <= P, norms are the largest
// component's.
//
// The direction d is L - o rounded, so at t the ray is at (1 - t) p + t e from the light, with
// |e_i| <= u |p_i|. Where it is at w >= r there, its slopes differ from those of p by less than
// 2 u P / r (1 + 2^-10), which for r = 160 u n P is 1/160 of a tile, 0.8 units. The place of p is
// found in float: p's components, their quotient, the sum with 1 and the product are off by 4 u n
// of a tile, 1/8 of a unit for n <= 4096. What rasterFromLight adds is below 1/2. Together that is
// less than the guard of 1.5. Triangles that come nearer than r to the light are `close`, and
// tested by all rays.
constexpr double kNearest = 160.0 * 0x1p-24;

/// Each bucket of tiles is some thread's: their heads, and their lists.
void fillLists(uint32_t tiles, Executor& executor, LightGrid& grid) {
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
    return heads.size() * sizeof(uint32_t) + near.size() * sizeof(float) +
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
    grid.tiles = 0;
    const size_t count = geometry.triangles.size();
    grid.position = geometry.frame.toGrid(light.position);
    // Origins lie within the scene, whose coordinates are below 2, or a rounding beside it.
    grid.reach = 2.5f + std::max({std::abs(grid.position.x), std::abs(grid.position.y),
                                  std::abs(grid.position.z)});
    if (!(grid.reach < 0x1p20f)) return;
    const LightCone cone(light, geometry.frame);
    const double wanted = std::sqrt(kTilesPerTriangle * (double) count / (6.0 * cone.part()));
    grid.tiles = (int) std::clamp(wanted, (double) kLeastTiles, (double) kMostTiles);
    grid.nearest = (float) (kNearest * grid.tiles * grid.reach);
    const uint32_t tiles = setFaces(cone, grid.tiles, grid.faces);

    grid.records.resize(count);
    grid.pieces.resize((count + kTrianglesPerPiece - 1) / kTrianglesPerPiece);
    executor.forRange(count, kTrianglesPerPiece, [&](size_t begin, size_t end) {
        scanFromLight(geometry, grid, begin, end, grid.pieces[begin / kTrianglesPerPiece]);
    });
    grid.close.clear();
    for (const LightPiece& piece : grid.pieces)
        grid.close.insert(grid.close.end(), piece.close.begin(), piece.close.end());
    if (grid.close.size() > kMostClose)
        grid.tiles = 0;
    else
        fillLists(tiles, executor, grid);
}

} // namespace dirt
