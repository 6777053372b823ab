#include "backend_cpu/memory_forecast.h"

#include "backend_cpu/build/fragments.h"
#include "backend_cpu/image/depth_lists.h"
#include "backend_cpu/image/eye_triangle.h"
#include "backend_cpu/image/raster_fetch.h"
#include "backend_cpu/light/light_grid.h"
#include "backend_cpu/trace/leaves.h"
#include "core/frame/memory_plan.h"

#include <algorithm>

namespace dirt {

namespace {

/// Vectors that grow by doubling have half as much again on the average.
constexpr double kGrown = 1.5;

/// Tiles of a light grid that list a triangle: its tiles are small where many triangles are.
constexpr double kLightTiles = 3.0;

/// Tiles of the image that a triangle on it lies in, where there are many; and such triangles for
/// each pixel: those between the pixels' centres are left out early.
constexpr double kEyeTiles = 1.5, kSeenPerPixel = 4.0;

double structureBytes(const Footprint& footprint, const GridSettings& grid) {
    GridSettings tilesAlone = grid;
    tilesAlone.bins = 1;
    const double tiles = footprint.tiles(grid);
    const double fragments = footprint.listEntries(tilesAlone);
    const double entries = std::max(footprint.listEntries(grid), fragments);
    // Depth bounds and a third more for the pyramid, the heads of the lists, and the leaves' tiles.
    const double perTile = sizeof(DepthBounds) * 4.0 / 3.0 + sizeof(uint32_t) * grid.bins +
                           sizeof(TileDepths) + sizeof(Leaves::TreeSize);
    // In the pieces of triangles, and in buckets.
    const double perFragment = (kGrown + 1.0) * sizeof(Fragment);
    // Blocks are half full, or one a tile; and a node stands over some.
    const double blocks = entries / (LeafBoxes::kChildren / 2) + std::min(tiles, fragments);
    return tiles * perTile + fragments * perFragment + entries * sizeof(uint32_t) +
           blocks * (sizeof(LeafBlock) + sizeof(LeafNode) / 4.0);
}

double geometryBytes(double triangles, const GridSettings& grid, const Requirements& need) {
    // The triangle buffer, and a byte for those without area.
    double bytes = sizeof(Triangle) + 1.0;
    if (need.shadowRays)
        bytes += sizeof(LightRecord) +
                 kLightTiles * ((kGrown + 1.0) * sizeof(LightFragment) + 3 * sizeof(uint32_t));
    const double seen = std::min(triangles, kSeenPerPixel * grid.width * grid.height);
    const double perSeen = (kGrown + 1.0) * sizeof(EyeTriangle) +
                           kEyeTiles * (kGrown * sizeof(DepthFragment) + sizeof(DepthEntry));
    return triangles * bytes + (need.tracedPrimary ? 0.0 : seen * perSeen);
}

double pathBytes(const RenderSettings& settings, const Requirements& need) {
    const double pixels = (double) settings.grid.width * settings.grid.height;
    double bytes = 0.0;
    for (const PlannedBuffer& buffer : planPaths(need, settings.grid))
        bytes += (double) buffer.bytes;
    // Rays that are cast, the hits that are fetched, and at the end the picture.
    if (need.indirect || need.tracedPrimary)
        bytes += pixels * ((kGrown + 1.0) * sizeof(HitEntry) + 2 * sizeof(uint32_t));
    return bytes + pixels * 2.0 * sizeof(glm::vec3);
}

} // namespace

MemoryForecast forecastMemory(const Footprint& footprint, uint64_t triangles,
                              const RenderSettings& settings, const Requirements& need) {
    return {(uint64_t) structureBytes(footprint, settings.grid),
            (uint64_t) geometryBytes((double) triangles, settings.grid, need),
            (uint64_t) pathBytes(settings, need)};
}

} // namespace dirt
