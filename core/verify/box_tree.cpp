#include "core/verify/box_tree.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace dirt {

namespace {

constexpr uint32_t kLeafSize = 4;

/// The ray in double, with what the slab test needs of it.
struct SlabRay {
    double origin[3], direction[3];

    explicit SlabRay(const Ray& ray) {
        for (int i = 0; i < 3; i++) origin[i] = ray.origin[i], direction[i] = ray.direction[i];
    }

    /// Whether the part t >= 0 meets the closed box. With u = 2^-53, a quotient (float - float) /
    /// float in double has two roundings, so it errs by less than 2.1 u; it is widened by 8 u, and
    /// the product that widens costs one u.
    bool meets(glm::vec3 lo, glm::vec3 hi) const {
        constexpr double kWiden = 0x1p-50;
        double enter = 0.0, leave = std::numeric_limits<double>::infinity();
        for (int i = 0; i < 3; i++) {
            if (direction[i] == 0.0) {
                if (origin[i] < lo[i] || origin[i] > hi[i]) return false;
                continue;
            }
            double near = (lo[i] - origin[i]) / direction[i];
            double far = (hi[i] - origin[i]) / direction[i];
            if (near > far) std::swap(near, far);
            enter = std::max(enter, near * (near > 0.0 ? 1.0 - kWiden : 1.0 + kWiden));
            leave = std::min(leave, far * (far > 0.0 ? 1.0 + kWiden : 1.0 - kWiden));
        }
        return enter <= leave;
    }
};

} // namespace

BoxTree::BoxTree(const std::vector<Triangle>& triangles) : ids_(triangles.size()) {
    std::iota(ids_.begin(), ids_.end(), 0u);
    if (!ids_.empty()) split(triangles, 0, (uint32_t) ids_.size());
}

void BoxTree::split(const std::vector<Triangle>& triangles, uint32_t first, uint32_t count) {
    Node node{glm::vec3(std::numeric_limits<float>::max()),
              glm::vec3(-std::numeric_limits<float>::max()), first, count};
    for (uint32_t i = first; i < first + count; i++) {
        const Triangle& t = triangles[ids_[i]];
        node.lo = glm::min(node.lo, glm::min(t.a, glm::min(t.b, t.c)));
        node.hi = glm::max(node.hi, glm::max(t.a, glm::max(t.b, t.c)));
    }
    const size_t self = nodes_.size();
    nodes_.push_back(node);
    if (count <= kLeafSize) return;

    const glm::vec3 size = node.hi - node.lo;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const auto centre = [&](uint32_t id) {
        const Triangle& t = triangles[id];
        return (double) t.a[axis] + t.b[axis] + t.c[axis];
    };
    const uint32_t half = count / 2;
    std::nth_element(ids_.begin() + first, ids_.begin() + first + half,
                     ids_.begin() + first + count,
                     [&](uint32_t l, uint32_t r) { return centre(l) < centre(r); });
    split(triangles, first, half);
    nodes_[self].first = (uint32_t) nodes_.size();
    nodes_[self].count = 0;
    split(triangles, first + half, count - half);
}

void BoxTree::candidates(const Ray& ray, std::vector<uint32_t>& out) const {
    if (nodes_.empty()) return;
    const SlabRay slabs(ray);
    uint32_t stack[64]; // halving 2^32 triangles goes 32 levels deep
    int top = 0;
    stack[top++] = 0;
    while (top > 0) {
        const uint32_t index = stack[--top];
        const Node& node = nodes_[index];
        if (!slabs.meets(node.lo, node.hi)) continue;
        if (node.count > 0) {
            out.insert(out.end(), ids_.begin() + node.first,
                       ids_.begin() + node.first + node.count);
        } else {
            stack[top++] = node.first;
            stack[top++] = index + 1;
        }
    }
}

} // namespace dirt
