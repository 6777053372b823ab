#pragma once

#include "core/grid/geometry.h"

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

} // namespace dirt
