#pragma once

#include "core/grid/geometry.h"
#include "core/trace/ray.h"

#include <cstdint>
#include <vector>

namespace dirt {

/// A plain binary tree of boxes over triangles that tells the judge which triangles a ray can
/// meet. Boxes are exact (smallest and largest of floats) and the ray test errs outwards, so that
/// no triangle is lost.
class BoxTree {
public:
    explicit BoxTree(const std::vector<Triangle>& triangles);

    /// Appends every triangle whose box the ray's part t >= 0 meets, and perhaps others.
    void candidates(const Ray& ray, std::vector<uint32_t>& out) const;

private:
    struct Node {
        glm::vec3 lo, hi;
        uint32_t first = 0; ///< leaf: into ids_; inner node: its second child (the first follows)
        uint32_t count = 0; ///< 0: inner node
    };

    void split(const std::vector<Triangle>& triangles, uint32_t first, uint32_t count);

    std::vector<Node> nodes_; ///< depth first
    std::vector<uint32_t> ids_;
};

} // namespace dirt
