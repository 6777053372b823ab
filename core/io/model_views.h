#pragma once

#include "core/io/model.h"
#include "core/scene/scene.h"

#include <optional>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>

namespace dirt {

/// A camera that a model file has.
struct ModelCamera {
    std::string name; ///< may be empty
    Camera camera;
    std::optional<double> halfHeight; ///< of what it shows, where it is orthographic
};

/// Appends the cameras of a model placed by \p toWorld, and, where \p lights has none, its light.
/// Throws InputError where one of them has no place there.
void placeModelViews(const Model& model, const glm::dmat4& toWorld, LoadReport& report,
                     std::vector<ModelCamera>& cameras, std::vector<Spotlight>& lights);

/// Makes a perspective camera that shows \p mesh nearly as the orthographic \p camera does: it
/// looks in the same direction from so far away that nothing of the mesh is larger or smaller by
/// more than a fraction of 1/16, and shows the middle of the mesh as large. What is behind the
/// camera may get into view.
Camera fromAfar(const ModelCamera& camera, const Mesh& mesh);

} // namespace dirt
