#pragma once

#include "backend_cpu/light_grid.h"

namespace dirt {

/// What a spotlight shines on, in the grid frame.
struct LightCone {
    glm::dvec3 axis;  ///< unit length
    double halfAngle; ///< radians; for a square frustum that of the cone around it

    LightCone(const Spotlight& light, const GridFrame& frame);
    /// As a part of all directions.
    double part() const;
};

/// The faces of \p tiles by \p tiles around the light: of each the rectangle of tiles that holds
/// the cone's part. Returns the number of tiles in all.
uint32_t setFaces(const LightCone& cone, int tiles, std::array<LightFace, 6>& faces);

} // namespace dirt
