#pragma once

#include "core/frame/tracer.h"
#include "core/scene/scene.h"

#include <optional>

#include <glm/vec3.hpp>

namespace dirt {

/// What the user has said about the camera of a scene that has none. Whatever is left out is
/// chosen.
struct CameraHints {
    std::optional<glm::vec3> eye;    ///< world space
    std::optional<glm::vec3> target; ///< world space
    glm::vec3 up{0.0f, 1.0f, 0.0f};  ///< not zero
    float verticalFov = 53.0f;       ///< degrees
    float aspect = 2.0f;             ///< width : height
};

/// Where to stand, where to look, and a light to see by.
struct Standpoint {
    Camera camera;
    Spotlight light;
};

/// Finds a place that shows \p mesh: of some hundred views, from inside its box and around it, the
/// one whose rays hit most and spread widest in depth, from outside of solids and not with a
/// surface before the lens. The light stands beside the eye. Builds \p tracer's structure once and
/// casts a few ten thousand rays. The same mesh gives the same standpoint; without triangles, or
/// where nothing can be hit, the mesh's box is looked at from in front.
Standpoint chooseStandpoint(const Mesh& mesh, Tracer& tracer, const CameraHints& hints);

} // namespace dirt
