#pragma once

#include "core/grid/geometry.h"

#include <cstdint>

namespace dirt {

/// Hierarchical: down and up the depth pyramid. Linear: tile by tile.
enum class Traversal { hierarchical, linear };

/// The choices that shape the structure and its traversal. None changes which triangle a ray hits.
struct GridSettings {
    ViewMode mode = ViewMode::full;
    int width = 1024; ///< image pixels
    int height = 512;
    int viewSize = 0; ///< pixels along a cube face; 0: the image's height
    int tile = 16;    ///< pixels along a tile
    int bins = 16;    ///< per tile
    int maxMip = -1;  ///< highest pyramid level used; -1: all
    Traversal traversal = Traversal::hierarchical;
};

/// The choices that shape the image.
struct RenderSettings {
    GridSettings grid;
    int samples = 16; ///< per pixel
    int bounces = 3;  ///< 1: direct light only
    uint32_t seed = 0;
};

} // namespace dirt
