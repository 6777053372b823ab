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
    /// Degrees. Left out: an object is seen as through a long lens, at 30, so that it is little
    /// distorted and its top can be seen from slightly above; a room as by default, at 53.
    std::optional<float> verticalFov;
    float aspect = 2.0f; ///< width : height
};

/// Where to stand, where to look, and a light to see by.
struct Standpoint {
    Camera camera;
    Spotlight light;
};

/// Finds a place that shows \p mesh. An object (see ModelKind) is shown whole, from outside, in
/// front and slightly above (see objectDirection). A room is shown from the place inside, or before
/// an opening, whose picture has most of the surface that is seen from within. The light stands
/// beside the eye. Builds \p tracer's structure once and casts some hundred thousand rays. The same
/// mesh gives the same standpoint; without triangles that can be seen, its box is looked at.
Standpoint chooseStandpoint(const Mesh& mesh, Tracer& tracer, const CameraHints& hints);

} // namespace dirt
