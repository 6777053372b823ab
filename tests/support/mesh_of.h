#pragma once

#include "core/grid/geometry.h"
#include "core/scene/scene.h"

#include <vector>

namespace dirt::test {

/// A mesh of these triangles, no vertex shared.
inline Mesh meshOf(const std::vector<Triangle>& triangles) {
    Mesh mesh;
    for (const Triangle& triangle : triangles) {
        const uint32_t first = (uint32_t) mesh.positions.size();
        mesh.positions.insert(mesh.positions.end(), {triangle.a, triangle.b, triangle.c});
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
    return mesh;
}

} // namespace dirt::test
