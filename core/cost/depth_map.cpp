#include "core/cost/depth_map.h"

#include "shaders/shared/margins.h"

#include <algorithm>
#include <bit>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace dirt {

namespace {

void lower(std::atomic<uint32_t>& value, uint32_t to) {
    uint32_t seen = value.load(std::memory_order_relaxed);
    while (to < seen && !value.compare_exchange_weak(seen, to, std::memory_order_relaxed)) {
    }
}

void raise(std::atomic<uint32_t>& value, uint32_t to) {
    uint32_t seen = value.load(std::memory_order_relaxed);
    while (to > seen && !value.compare_exchange_weak(seen, to, std::memory_order_relaxed)) {
    }
}

} // namespace

DepthMap::DepthMap(int columns, int rows, double rimX, double rimY)
    : columns_(columns), rows_(rows), rimX_(rimX), rimY_(rimY), near_((size_t) columns * rows),
      far_((size_t) columns * rows) {
    const Range empty;
    for (auto& near : near_) near = std::bit_cast<uint32_t>(empty.near);
    for (auto& far : far_) far = std::bit_cast<uint32_t>(empty.far);
}

DepthMap::Box DepthMap::boxOf(const SeenPolygon& polygon) const {
    const glm::dvec3 low = polygon.low(), high = polygon.high();
    const auto tile = [](double slope, double rim, int tiles) {
        return std::clamp((int) ((slope + rim) / (2.0 * rim) * tiles), 0, tiles - 1);
    };
    return {tile(low.x, rimX_, columns_), tile(low.y, rimY_, rows_), tile(high.x, rimX_, columns_),
            tile(high.y, rimY_, rows_)};
}

bool DepthMap::meets(const SeenPolygon& polygon, int x, int y) const {
    const glm::dvec2 half(rimX_ / columns_, rimY_ / rows_);
    const glm::dvec2 middle(-rimX_ + (2 * x + 1) * half.x, -rimY_ + (2 * y + 1) * half.y);
    bool left = false, right = false; // an edge with the tile on that side
    for (int i = 0; i < polygon.count; ++i) {
        const glm::dvec2 a(polygon.corners[i]), b(polygon.corners[(i + 1) % polygon.count]);
        const glm::dvec2 normal(a.y - b.y, b.x - a.x);
        const double distance = glm::dot(normal, middle - a);
        const double reach = std::abs(normal.x) * half.x + std::abs(normal.y) * half.y;
        left = left || distance > reach;
        right = right || distance < -reach;
    }
    return !(left && right);
}

DepthMap::Range DepthMap::depthsIn(const SeenPolygon& polygon, const Bounds& whole, int x,
                                   int y) const {
    const glm::dvec3 plane = polygon.inverseDepth;
    Range range{(float) whole.low.z, (float) whole.high.z};
    if (plane == glm::dvec3(0.0)) return range;
    // 1/w is linear: its extremes are at corners of what tile and bounding box have in common.
    const glm::dvec2 size(2.0 * rimX_ / columns_, 2.0 * rimY_ / rows_);
    const glm::dvec2 corner(-rimX_ + x * size.x, -rimY_ + y * size.y);
    const glm::dvec2 low = glm::max(corner, glm::dvec2(whole.low));
    const glm::dvec2 high = glm::min(corner + size, glm::dvec2(whole.high));
    const double middle = glm::dot(plane, glm::dvec3((low + high) / 2.0, 1.0));
    const double swing =
        (std::abs(plane.x) * (high.x - low.x) + std::abs(plane.y) * (high.y - low.y)) / 2.0;
    const auto within = [&](double depth) {
        return (float) std::clamp(depth, whole.low.z, whole.high.z);
    };
    if (middle + swing > 0.0) range.near = within((1.0 - kDepthMargin) / (middle + swing));
    if (middle - swing > 0.0) range.far = within((1.0 + kDepthMargin) / (middle - swing));
    return range;
}

template <typename Use>
void DepthMap::forTiles(const SeenPolygon& polygon, const Use& use) const {
    const Box box = boxOf(polygon);
    const Bounds whole{polygon.low(), polygon.high()};
    if (box.x0 == box.x1 && box.y0 == box.y1) {
        use(box.x0, box.y0, Range{(float) whole.low.z, (float) whole.high.z});
        return;
    }
    for (int y = box.y0; y <= box.y1; ++y)
        for (int x = box.x0; x <= box.x1; ++x)
            if (meets(polygon, x, y)) use(x, y, depthsIn(polygon, whole, x, y));
}

void DepthMap::include(const SeenPolygon& polygon) {
    forTiles(polygon, [this](int x, int y, const Range& depths) {
        const size_t at = (size_t) y * columns_ + x;
        lower(near_[at], std::bit_cast<uint32_t>(depths.near));
        raise(far_[at], std::bit_cast<uint32_t>(depths.far));
    });
}

bool DepthMap::spansTiles(const SeenPolygon& polygon) const {
    const Box box = boxOf(polygon);
    return box.x1 - box.x0 > 1 || box.y1 - box.y0 > 1;
}

double DepthMap::rangesCrossed(const SeenPolygon& polygon) const {
    double sum = 0.0;
    forTiles(polygon, [&](int x, int y, const Range& depths) {
        const double length = range(x, y).length();
        if (length > 0.0) sum += std::min(1.0, depths.length() / length);
    });
    return sum;
}

double DepthMap::inverseLength(const SeenPolygon& polygon) const {
    double sum = 0.0;
    int count = 0;
    forTiles(polygon, [&](int x, int y, const Range&) {
        const double length = range(x, y).length();
        sum += length > 0.0 ? 1.0 / length : 0.0;
        count += length > 0.0;
    });
    return count > 0 ? sum / count : 0.0;
}

DepthMap DepthMap::coarser() const {
    DepthMap half((columns_ + 1) / 2, (rows_ + 1) / 2, rimX_, rimY_);
    for (int y = 0; y < rows_; ++y)
        for (int x = 0; x < columns_; ++x) {
            const size_t from = (size_t) y * columns_ + x;
            const size_t to = (size_t) (y / 2) * half.columns_ + x / 2;
            lower(half.near_[to], near_[from]);
            raise(half.far_[to], far_[from]);
        }
    return half;
}

DepthMap::Range DepthMap::range(int x, int y) const {
    const size_t at = (size_t) y * columns_ + x;
    return {std::bit_cast<float>(near_[at].load(std::memory_order_relaxed)),
            std::bit_cast<float>(far_[at].load(std::memory_order_relaxed))};
}

} // namespace dirt
