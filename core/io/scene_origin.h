#pragma once

#include "core/io/model.h"
#include "core/io/scene_file.h"
#include "core/scene/origin.h"
#include "core/scene/scene.h"

#include <map>
#include <vector>

#include <glm/mat4x4.hpp>

namespace dirt {

/// The points of a model that its triangles use.
class ModelPoints {
public:
    explicit ModelPoints(const Model& model);

    /// Adds them, placed by \p matrix, to a box.
    void include(const glm::dmat4& matrix, Bounds& bounds) const;

private:
    const Model& model_;
    std::vector<std::vector<bool>> used_; ///< positions of the OBJ file, or of each glTF primitive
};

/// Finds the origins of a scene: of the world, from the box of all that stands in it at frame 0,
/// and of each model that moves, from its box in its own space.
class OriginFinder {
public:
    explicit OriginFinder(const Animation& animation) : animation_(animation) {}

    /// One more model, which must outlive this, where a scene file places it.
    void add(const Model& model, const glm::dmat4& toSpace, uint32_t space);

    glm::dvec3 ofWorld() const { return originFor(world_); }
    /// Of the space of the model that was added as the \p index th.
    glm::dvec3 ofSpace(size_t index) const;

private:
    const Animation& animation_;
    std::map<const Model*, ModelPoints> points_;
    Bounds world_;
    std::vector<std::optional<glm::dvec3>> moving_; ///< none: it stands in the world
};

/// \p matrix with \p origin taken off where it leads.
glm::dmat4 relativeTo(const glm::dvec3& origin, glm::dmat4 matrix);

/// Takes \p scene's origin off the points of its scene file, in double, rounded once: camera, light
/// and their key frames, and what moves. Throws InputError with the element's line where points
/// that have to differ are the same in float32.
void moveToOrigin(const SceneFile& source, Scene& scene);

} // namespace dirt
