#include "core/io/polygon_points.h"

#include <algorithm>
#include <numeric>

#include <glm/common.hpp>

namespace dirt {

namespace {

/// A line of a triangle: from one corner towards the next.
struct Side {
    glm::dvec2 from, to;

    double at(glm::dvec2 p) const { return turn(from, to, p); }

    /// at(p) is at most this for all p of the box, whatever is rounded: it grows with p.y and falls
    /// with p.x where the factors are positive, and every operation's rounding is monotone.
    double most(glm::dvec2 low, glm::dvec2 high) const {
        return at({to.y - from.y > 0.0 ? low.x : high.x, to.x - from.x > 0.0 ? high.y : low.y});
    }
};

} // namespace

void PolygonPoints::set(std::span<const glm::dvec2> points) {
    const auto count = (uint32_t) points.size();
    order_.resize(count);
    std::iota(order_.begin(), order_.end(), 0u);
    std::sort(order_.begin(), order_.end(), [&](uint32_t a, uint32_t b) {
        return points[a].x != points[b].x ? points[a].x < points[b].x : points[a].y < points[b].y;
    });
    points_.clear();
    place_.resize(count);
    for (const uint32_t corner : order_) {
        if (points_.empty() || points_.back() != points[corner]) points_.push_back(points[corner]);
        place_[corner] = (uint32_t) points_.size() - 1;
    }
    const auto places = (uint32_t) points_.size();
    used_.assign(places, 0);
    leaf_.resize(places);
    order_.resize(places);
    std::iota(order_.begin(), order_.end(), 0u);
    nodes_.clear();
    split(0, 0, places);
}

void PolygonPoints::split(size_t node, uint32_t begin, uint32_t end) {
    glm::dvec2 low = points_[order_[begin]], high = low;
    for (uint32_t i = begin; i < end; ++i) {
        low = glm::min(low, points_[order_[i]]);
        high = glm::max(high, points_[order_[i]]);
    }
    if (nodes_.size() <= node) nodes_.resize(node + 1);
    nodes_[node] = {low, high, begin, end, 0};
    if (end - begin <= kLeaf) {
        for (uint32_t i = begin; i < end; ++i) leaf_[order_[i]] = (uint32_t) node;
        return;
    }
    const int axis = high.x - low.x > high.y - low.y ? 0 : 1;
    const uint32_t middle = begin + (end - begin) / 2;
    std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                     [&](uint32_t a, uint32_t b) { return points_[a][axis] < points_[b][axis]; });
    split(2 * node + 1, begin, middle);
    split(2 * node + 2, middle, end);
}

void PolygonPoints::count(uint32_t place, int change) {
    const uint32_t before = used_[place];
    used_[place] = before + (uint32_t) change;
    if ((before > 0) == (used_[place] > 0)) return;
    for (size_t node = leaf_[place];; node = (node - 1) / 2) {
        nodes_[node].used += (uint32_t) change;
        if (node == 0) return;
    }
}

uint32_t PolygonPoints::inside(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c, bool closed) const {
    const Side sides[] = {{a, b}, {b, c}, {c, a}};
    const auto allows = [&](double value) { return closed ? value >= 0.0 : value > 0.0; };
    uint32_t stack[64]; // the tree halves: as deep as a place's number has bits
    int open = 0;
    stack[open++] = 0;
    while (open > 0) {
        const size_t at = stack[--open];
        const Node& node = nodes_[at];
        if (node.used == 0 || !std::all_of(std::begin(sides), std::end(sides), [&](const Side& s) {
                return allows(s.most(node.low, node.high));
            }))
            continue;
        if (node.end - node.begin > kLeaf) {
            stack[open++] = (uint32_t) (2 * at + 2);
            stack[open++] = (uint32_t) (2 * at + 1);
            continue;
        }
        for (uint32_t i = node.begin; i < node.end; ++i) {
            const uint32_t place = order_[i];
            const glm::dvec2 p = points_[place];
            if (used_[place] == 0 || p == a || p == b || p == c) continue;
            if (std::all_of(std::begin(sides), std::end(sides),
                            [&](const Side& s) { return allows(s.at(p)); }))
                return place;
        }
    }
    return kNone;
}

} // namespace dirt
