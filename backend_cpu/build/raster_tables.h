#pragma once

#include "core/grid/grid.h"

#include <cstdint>
#include <vector>

namespace dirt {

/// The views of a grid as the SIMD rasterizer reads them. All views of a grid have the same
/// borders.
struct RasterTables {
    static constexpr int kViews = 8;       ///< at most; tables are read as a whole
    static constexpr size_t kPadding = 16; ///< borders that may be read beyond the last

    /// One direction of the image, columns or rows.
    struct Axis {
        int tiles = 0;
        /// Guard-banded borders: low[i] and high[i] of tile i. Tile -1 has a high border before
        /// everything, tile `tiles` a low one behind everything.
        const float* low = nullptr;
        const float* high = nullptr;
        float tilesPerSlope = 0.0f, middle = 0.0f; ///< position of a slope, in tiles
        float end = 0.0f;                          ///< position of the rim, in tiles
        float beyond = 0.0f;                       ///< a slope behind all guard bands
    };
    Axis axes[2]; ///< columns, rows

    int views = 0;
    int axis[3][kViews] = {}; ///< components of x, y and w in the grid frame
    float sign[kViews] = {};  ///< of w
    uint32_t tilesPerView = 0;
    /// Whether all borders are zero or between 2^-60 and 2^20, so that no product with ordinary
    /// coordinates underflows.
    bool ordinary = false;

    /// Keeps its memory.
    void set(const Grid& grid);

private:
    std::vector<float> low_[2], high_[2];
};

} // namespace dirt
