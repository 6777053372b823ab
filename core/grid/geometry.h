#pragma once

#include "core/scene/cut_outs.h"
#include "core/scene/scene.h"

#include <cstdint>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace dirt {

/// Single: only the camera's view. Full: six cube faces around the eye.
enum class ViewMode { full, single };

/// One triangle of the triangle buffer: positions in the grid frame.
struct Triangle {
    glm::vec3 a, b, c;
};

/// The grid frame: world position minus the eye, on world axes (full) or on the camera's axes
/// right, down, forward (single), times one power of two that brings the largest |coordinate| of
/// the scene into [1, 2). See docs/grid.md.
struct GridFrame {
    glm::vec3 eye{0.0f};        ///< world space
    glm::vec3 right{1, 0, 0};   ///< rows of the rotation, world space,
    glm::vec3 down{0, 1, 0};    ///<   rounded to float once;
    glm::vec3 forward{0, 0, 1}; ///<   identity in full mode
    float scale = 1.0f;         ///< a power of two
    ViewMode mode = ViewMode::full;

    /// World position to grid frame, by the very operations that make the triangle buffer.
    glm::vec3 toGrid(glm::vec3 world) const;
    /// World direction to grid frame (no scale).
    glm::vec3 directionToGrid(glm::vec3 world) const;
};

/// The frame's geometry: what rays, hits, Embree and the exact oracle refer to, and nothing else.
struct FrameGeometry {
    GridFrame frame;
    std::vector<Triangle> triangles; ///< the triangle buffer; the index is the primitive id
    /// The scene whose materials cut holes or have one side, alive while rays are cast; null: there
    /// are none.
    const Scene* cutOuts = nullptr;

    /// Whether isHit (core/trace/holes.h) has to be asked.
    bool mayHaveHoles(uint32_t primitive) const {
        return cutOuts && cutOuts->materials[cutOuts->mesh.materials[primitive]].hasCutOuts();
    }
};

/// Camera basis in world space: right, down, forward; computed in double, rounded once.
struct CameraBasis {
    glm::vec3 right, down, forward;
};
CameraBasis cameraBasis(const Camera& camera);

/// The grid frame of \p camera with a scale of 1.
GridFrame makeUnscaledFrame(const Camera& camera, ViewMode mode);

/// The grid frame's scale where the largest |coordinate| is \p largest: the power of two that
/// brings it into [1, 2), as far as float32 can hold it. Throws InputError where \p largest is
/// infinite or NaN.
float scaleFor(float largest);

/// Brings a scene into the grid frame of \p camera.
FrameGeometry makeFrameGeometry(const Mesh& mesh, const Camera& camera, ViewMode mode);

} // namespace dirt
