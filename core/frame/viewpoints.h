#pragma once

#include "core/frame/auto_camera.h"

#include <limits>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace dirt {

/// A mesh along axes that follow its up direction: its box, and where its corners are.
/// Coordinates are (right, up, forward), in world units.
struct SceneExtent {
    glm::dvec3 right, up, forward; ///< orthonormal, world space
    glm::dvec3 low{std::numeric_limits<double>::max()};
    glm::dvec3 high{std::numeric_limits<double>::lowest()};
    std::vector<double> spotsRight, spotsForward; ///< quantiles of the corners; the middle

    glm::dvec3 world(glm::dvec3 q) const { return q.x * right + q.y * up + q.z * forward; }
    glm::dvec3 centre() const { return 0.5 * (low + high); }
    double diagonal() const { return glm::length(high - low); }
    /// The shortest edge of the box: of most scenes the height.
    double least() const {
        const glm::dvec3 size = high - low;
        return glm::min(size.x, glm::min(size.y, size.z));
    }
};

SceneExtent extentOf(const Mesh& mesh, glm::vec3 up);

/// A place to try, and the directions to try from it.
struct Viewpoint {
    glm::dvec3 eye;                     ///< world space
    std::vector<glm::dvec3> directions; ///< world space, unit length
    bool inside;                        ///< within the scene's box
};

/// Places within the box where geometry is near, and around it where all of it is in view; or only
/// the eye, or the direction, that \p hints gives.
std::vector<Viewpoint> viewpoints(const SceneExtent& extent, const CameraHints& hints);

} // namespace dirt
