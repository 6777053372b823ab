#pragma once

#include <glm/vec3.hpp>

namespace dirt {

/// Spotlight, traced as a point. Its intensity on the axis is
/// flux * color / (2 pi (1 - cos(aperture / 2))); between the penumbra's and the aperture's cone
/// it falls off as ((cos theta - cos outer) / (cos inner - cos outer))^exponent.
struct Spotlight {
    glm::vec3 position{0.0f};
    glm::vec3 target{0.0f, -1.0f, 0.0f};
    glm::vec3 color{1.0f};
    double flux = 1.0;      ///< proportional to the square of a scene's scale; see roundedFlux
    float aperture = 90.0f; ///< full angle of the outer cone, degrees
    float penumbra = 80.0f; ///< full angle of the inner cone, degrees
    float exponent = 1.0f;
    bool conical = true; ///< false: a square frustum
    bool shadows = true; ///< false: it reaches whatever faces it, as if nothing were between

    // Of its shadow map, where it has one.
    int resolution = 1024;       ///< texels along a side
    float nearRange = 0.0f;      ///< depths along the axis between which things cast;
    float farRange = 0.0f;       ///<   0: whatever is farther
    float constantBias = 0.001f; ///< of the range, or of the scene's depth where it has no end
    float softShadowSize = 0.0f; ///< width over which a shadow's edge is blurred
};

/// \p flux with as many digits as a float has, whatever its exponent: that of a light which is to
/// shine on a scene of 1e25 alike is beyond float.
double roundedFlux(double flux);

} // namespace dirt
