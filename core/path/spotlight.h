#pragma once

#include "core/grid/geometry.h"
#include "core/scene/light.h"

#include <glm/vec3.hpp>

namespace dirt {

/// What a point receives from a light, if nothing is between them.
struct LightSample {
    glm::vec3 toLight;    ///< light minus point, grid frame
    glm::vec3 direction;  ///< the same with unit length
    glm::vec3 irradiance; ///< on a surface that faces the light; zero outside its cone
};

/// A spotlight in the grid frame. Irradiance is in world units: the grid's scale is undone.
class GridSpotlight {
public:
    GridSpotlight(const Spotlight& light, const GridFrame& frame);

    /// \p point is in the grid frame.
    LightSample sample(glm::vec3 point) const;

    glm::vec3 position() const { return position_; }

private:
    float falloff(glm::vec3 fromLight) const;

    glm::vec3 position_;
    glm::vec3 axis_, right_, up_; ///< unit vectors
    glm::vec3 intensity_;         ///< on the axis, per squared length of the grid frame
    float outer_;                 ///< 1 - cos of the half aperture
    float range_;                 ///< outer_ less the same of the penumbra
    float exponent_;
    bool conical_;
};

} // namespace dirt
