#pragma once

#include "core/grid/geometry.h"
#include "core/scene/scene.h"
#include "core/trace/ray.h"

#include <glm/vec3.hpp>

namespace dirt {

/// A surface point of the shading buffer: G[k]. Positions and directions are in the grid frame.
struct SurfacePoint {
    glm::vec3 position;
    glm::vec3 geometricNormal; ///< unit length, on the side the ray came from
    glm::vec3 shadingNormal;   ///< unit length, on the same side of the surface
    glm::vec3 diffuse;         ///< Kd or the texel of map_Kd, linear Rec.709
    glm::vec3 emission;        ///< Ke, radiance, on both sides
};

/// Fetch by primitive id: the surface point at \p hit, a hit of \p ray. A triangle without normals
/// has its geometric one for shading; one without texture coordinates has its material's Kd.
SurfacePoint fetchSurface(const Scene& scene, const FrameGeometry& geometry, const Ray& ray,
                          const Hit& hit);

} // namespace dirt
