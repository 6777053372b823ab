#pragma once

#include "core/grid/geometry.h"

#include <cstdint>

namespace dirt {

/// Hierarchical: down and up the depth pyramid. Linear: tile by tile.
enum class Traversal { hierarchical, linear };

/// Exact: whether a ray hits is decided by exact signs, and tiles have a guard band, so that no hit
/// is lost. Fast: a plain float test and no guard band; hits at edges are lost or invented, and
/// other tiles and backends may find others.
enum class Precision { exact, fast };

/// The choices that shape the structure and its traversal. None but the precision changes which
/// triangle a ray hits.
struct GridSettings {
    ViewMode mode = ViewMode::full;
    int width = 1024; ///< image pixels
    int height = 512;
    int viewSize = 0; ///< pixels along a cube face; 0: the image's height
    int tile = 16;    ///< pixels along a tile
    int bins = 16;    ///< per tile
    int maxMip = -1;  ///< highest pyramid level used; -1: all
    Traversal traversal = Traversal::hierarchical;
    Precision precision = Precision::exact; ///< of Trace and Visibility

    bool operator==(const GridSettings&) const = default;
};

/// How primary rays find their surface: by rasterization, or traced like all others.
enum class Primary { raster, traced };

/// How material data reaches a hit: by rasterizing the scene against the hit lists, or by
/// primitive id.
enum class Fetch { raster, direct };

/// How it is found whether the light reaches a point: by a ray, or in a shadow map.
enum class LightVisibility { traced, shadowMap };

/// How exactly the shading buffer keeps surface points: in 80 bytes, or in 32 at most.
enum class Shading { full, packed };

/// What indirect rays take every surface for, to look at: itself; Lambert's; a metal of roughness
/// 0.1; a mirror; or nothing, where the image shows the part of a cosine hemisphere that is open.
enum class RayType { normal, diffuse, glossy, specular, visibility };

/// The choices that shape the image, and two that only change how it is found: primary and fetch.
struct RenderSettings {
    GridSettings grid;
    int samples = 16; ///< per pixel
    int bounces = 3;  ///< 1: direct light only
    uint32_t seed = 0;
    RayType rayType = RayType::normal;
    bool roulette = true; ///< paths beyond three bounces go on by chance
    Primary primary = Primary::raster;
    Fetch fetch = Fetch::raster;
    LightVisibility visibility = LightVisibility::traced;
    Shading shading = Shading::full;

    bool operator==(const RenderSettings&) const = default;
};

} // namespace dirt
