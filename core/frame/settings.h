#pragma once

#include "core/grid/settings.h"

#include <cstdint>

namespace dirt {

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
