#include "backend_cpu/leaf_boxes.h"

#include <algorithm>
#include <bit>
#include <cfloat>

#include <glm/common.hpp>

namespace dirt {

LeafItem boxOfCell(const Grid& grid, int view, int tile, int bin) {
    const View& v = grid.views[view];
    const DepthBounds& bounds = grid.bounds(view, tile);
    const BinMap map(bounds, grid.settings.bins);
    // (w - near) scale has three roundings, of 2^-24 each, and the sums here one more; all lie
    // within 2^-21 of the far depth.
    const float slack = 0x1p-21f * bounds.far;
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
    LeafItem box{};
    box.low[v.axisX] = lowest(v.sLo[column]), box.high[v.axisX] = highest(v.sHi[column]);
    box.low[v.axisY] = lowest(v.tLo[row]), box.high[v.axisY] = highest(v.tHi[row]);
    box.low[v.axisW] = v.signW > 0.0f ? near : -far;
    box.high[v.axisW] = v.signW > 0.0f ? far : -near;
    return box;
}

LeafItem boxOfPart(const Triangle& t, uint32_t id, const LeafItem& cell) {
    LeafItem item;
    // A triangle beside the box, listed for the guard band's or a depth's margin, keeps a point.
    const glm::vec3 low = glm::min(glm::min(t.a, t.b), t.c);
    const glm::vec3 high = glm::max(glm::max(t.a, t.b), t.c);
    item.low = glm::min(glm::max(cell.low, low), high);
    item.high = glm::max(glm::min(cell.high, high), low);
    item.id = id;
    return item;
}

int widestAxis(std::span<const LeafItem> items) {
    glm::vec3 low(FLT_MAX), high(-FLT_MAX);
    for (const LeafItem& item : items) {
        const glm::vec3 middle = item.low + item.high;
        low = glm::min(low, middle);
        high = glm::max(high, middle);
    }
    const glm::vec3 size = high - low;
    return size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
}

void NodeBoxes::add(std::span<const LeafItem> items) {
    glm::vec3 low = items[0].low, high = items[0].high;
    for (const LeafItem& item : items) {
        low = glm::min(low, item.low);
        high = glm::max(high, item.high);
    }
    low_[count_] = low, high_[count_] = high;
    ++count_;
}

void NodeBoxes::write(LeafNode& node) const {
    glm::vec3 low = low_[0], high = high_[0];
    for (int i = 1; i < count_; ++i) {
        low = glm::min(low, low_[i]);
        high = glm::max(high, high_[i]);
    }
    for (int axis = 0; axis < 3; ++axis) {
        // The power of two above a 254th of the extent: the quotients below stay under 255, and
        // are off by less than 2^-23 of the extent, which the ray's test allows for.
        const float least = std::max((high[axis] - low[axis]) * (1.0f / 254.0f), 0x1p-60f);
        node.origin[axis] = low[axis];
        node.exponent[axis] = (uint8_t) ((std::bit_cast<uint32_t>(least) >> 23) + 1);
        const float inverse = 1.0f / node.step(axis);
        for (int i = 0; i < LeafNode::kChildren; ++i) {
            const int child = std::min(i, count_ - 1);
            const float from = (low_[child][axis] - low[axis]) * inverse;
            const float to = (high_[child][axis] - low[axis]) * inverse;
            node.bound[0][axis][i] = (uint8_t) from;
            node.bound[1][axis][i] = (uint8_t) std::min(to + 1.0f, 255.0f);
        }
    }
}

} // namespace dirt
