#pragma once

#include "core/scene/scene.h"
#include "shaders/shared/surface.h"

#include <optional>
#include <vector>

namespace dirt {

/// Whether a triangle has the attribute at each of its corners.
inline bool isPresent(const Corners& corners) {
    return corners[0] != kNoIndex && corners[1] != kNoIndex && corners[2] != kNoIndex;
}

/// The attribute at barycentric weights (\p u, \p v).
template <typename Vector>
Vector interpolateAt(const std::vector<Vector>& values, const Corners& corners, float u, float v) {
    return interpolate(values[corners[0]], values[corners[1]], values[corners[2]], u, v);
}

/// Texture coordinates, where the triangle has any.
inline std::optional<glm::vec2> texcoordAt(const Mesh& mesh, uint32_t primitive, float u, float v) {
    if (mesh.texcoords.empty() || !isPresent(mesh.texcoordIndices[primitive])) return {};
    return interpolateAt(mesh.texcoords, mesh.texcoordIndices[primitive], u, v);
}

} // namespace dirt
