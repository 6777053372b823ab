#pragma once

#include <cstdint>

#include "scenes/generate/mesh.h"

namespace dirt::generate {

/// A banner in metres: hung over a balustrade's rail, it falls free in front of the wall below.
struct BannerShape {
    double width;
    double length;     ///< of the fall, from the rail's top down
    double projection; ///< how far the cornice below pushes it out
    double cornice;    ///< depth of that cornice below the rail
    int material;
    int trimMaterial;
    std::uint32_t seed;
};

/// The banner: the origin is the rail's front top edge at the banner's middle, z leads out.
Mesh makeBanner(const Detail& detail, const BannerShape& shape);

/// A curtain in an arched opening of half width `halfWidth`, gathered at height `tie` to the side
/// of positive x. The origin is the middle of the sill; the rod is at `height`.
Mesh makeCurtain(const Detail& detail, int material, int trimMaterial, double halfWidth,
                 double height, double tie, std::uint32_t seed);

} // namespace dirt::generate
