#include "backend_cpu/trace/leaf_boxes.h"

#include "shaders/shared/margins.h"

#include <algorithm>
#include <cfloat>

#include <glm/common.hpp>

namespace dirt {

LeafBox boxOfCell(const Grid& grid, int view, int tile, int bin) {
    const View& v = grid.views[view];
    const DepthBounds& bounds = grid.bounds(view, tile);
    const BinMap map(bounds, grid.settings.bins);
    // The bin of w, (w - near) scale, has three roundings of 2^-24 each, scale's among them; what
    // stands here, four. None is of more than the far depth, and 2^-21 is eight.
    const float slack = kCellSlack * bounds.far;
    const float thickness = map.scale > 0.0f ? 1.0f / map.scale : FLT_MAX;
    const float near =
        bin == 0 ? bounds.near : std::max(bounds.near, bounds.near + bin * thickness - slack);
    const float far = bin == map.bins - 1 || map.scale == 0.0f
                          ? bounds.far
                          : std::min(bounds.far, bounds.near + (bin + 1) * thickness + slack);

    // The listed guard band of 1/128 leaves the 1/512 that is needed far more than its rounding.
    const auto lowest = [&](float s) { return std::min(s * near, s * far); };
    const auto highest = [&](float s) { return std::max(s * near, s * far); };
    const int column = tile % v.columns, row = tile / v.columns;
    LeafBox box{};
    box.low[v.axisX] = lowest(v.sLo[column]), box.high[v.axisX] = highest(v.sHi[column]);
    box.low[v.axisY] = lowest(v.tLo[row]), box.high[v.axisY] = highest(v.tHi[row]);
    box.low[v.axisW] = v.signW > 0.0f ? near : -far;
    box.high[v.axisW] = v.signW > 0.0f ? far : -near;
    return box;
}

void LeafBox::include(const LeafBox& box) {
    low = glm::min(low, box.low);
    high = glm::max(high, box.high);
}

} // namespace dirt
