#pragma once

#include <glm/vec3.hpp>

namespace dirt {

/// Perspective camera. World space is right-handed, Y up.
struct Camera {
    glm::vec3 eye{0.0f};
    glm::vec3 target{0.0f, 0.0f, -1.0f};
    glm::vec3 up{0.0f, 1.0f, 0.0f};
    float verticalFov = 45.0f;   ///< degrees
    float apertureRadius = 0.0f; ///< of a thin lens at the eye; 0: a pinhole
    float focalDistance = 1.0f;  ///< of the plane, at right angles to the view, that is in focus
};

/// Display encoding: with V the value of HSV,
/// V' = log(1.0001 + 10^key V) / log(1.0001 + 10^key white).
struct ToneMapping {
    float key = 1.0f;
    float white = 1.0f; ///< the largest component of the file's `white`
};

} // namespace dirt
