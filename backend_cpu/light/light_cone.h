#pragma once

#include "backend_cpu/light/light_tree.h"
#include "core/scene/light.h"

namespace dirt {

/// What a spotlight shines on, in the grid frame.
struct LightCone {
    glm::dvec3 axis;  ///< unit length
    double halfAngle; ///< radians; for a square frustum that of the cone around it

    LightCone(const Spotlight& light, const GridFrame& frame);
    /// As a part of all directions.
    double part() const;
};

/// The faces of \p roots by \p roots around the light: of each the rectangle of roots that holds
/// the cone's part. Returns the number of roots in all.
uint32_t setFaces(const LightCone& cone, int roots, std::array<LightFace, 6>& faces);

} // namespace dirt
