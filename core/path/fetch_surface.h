#pragma once

#include "core/grid/geometry.h"
#include "core/scene/scene.h"
#include "shaders/shared/layouts.h"

#include <glm/vec3.hpp>

namespace dirt {

/// Fetch by primitive id: the surface point at the barycentric weights (\p u, \p v) of
/// \p primitive, seen along \p direction. A triangle without normals has its geometric one for
/// shading; one without texture coordinates has its material's Kd.
SurfacePoint fetchSurface(const Scene& scene, const FrameGeometry& geometry, glm::vec3 direction,
                          uint32_t primitive, float u, float v);

} // namespace dirt
