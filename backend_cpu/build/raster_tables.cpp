#include "backend_cpu/build/raster_tables.h"

#include <algorithm>
#include <cmath>

namespace dirt {
namespace {

/// Behind any slope that is compared with it: coordinates are below 2^20 and depths above 2^-30.
constexpr float kNever = 0x1p60f;

bool allOrdinary(const std::vector<float>& borders) {
    // tile_range-inl.h needs this much.
    return std::all_of(borders.begin(), borders.end(), [](float slope) {
        const float size = std::fabs(slope);
        return slope == 0.0f || (size >= 0x1p-60f && size <= 0x1p20f);
    });
}

} // namespace

void RasterTables::set(const Grid& grid) {
    views = (int) grid.views.size();
    const View& first = grid.views[0];
    tilesPerView = (uint32_t) first.tiles();
    for (int v = 0; v < views; ++v) {
        axis[0][v] = grid.views[v].axisX;
        axis[1][v] = grid.views[v].axisY;
        axis[2][v] = grid.views[v].axisW;
        sign[v] = grid.views[v].signW;
    }
    ordinary = true;
    for (int i = 0; i < 2; ++i) {
        Axis& a = axes[i];
        const std::vector<float>& lows = i == 0 ? first.sLo : first.tLo;
        const std::vector<float>& highs = i == 0 ? first.sHi : first.tHi;
        low_[i].assign(lows.begin(), lows.end());
        low_[i].resize(lows.size() + kPadding, kNever);
        high_[i].assign(1, -kNever);
        high_[i].insert(high_[i].end(), highs.begin(), highs.end());
        high_[i].resize(high_[i].size() + kPadding, kNever);
        a.low = low_[i].data();
        a.high = high_[i].data() + 1;

        a.tiles = i == 0 ? first.columns : first.rows;
        const double pixels = i == 0 ? first.width : first.height;
        const double rim = i == 0 ? first.s.back() : first.t.back();
        const double tiles = pixels / grid.settings.tile;
        a.tilesPerSlope = (float) (tiles / (2.0 * rim));
        a.middle = (float) (0.5 * tiles);
        a.end = (float) tiles;
        a.beyond = 1.001f * highs.back();
        ordinary = ordinary && allOrdinary(lows) && allOrdinary(highs);
    }
}

} // namespace dirt
