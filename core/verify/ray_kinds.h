#pragma once

#include "core/frame/settings.h"
#include "core/grid/geometry.h"
#include "core/grid/view.h"
#include "core/trace/ray.h"
#include "core/verify/random.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace dirt {

/// The rays that `verify` casts, in the grid frame.
enum class RayKind {
    primary, ///< from the eye, through random image points
    diffuse, ///< from surface points that primary rays see, cosine-distributed
    vertex,  ///< from random points of the scene's box to a random vertex
    edge,    ///< likewise, to a random point of a random edge
    axis,    ///< along a coordinate axis, from random points or with vertices' coordinates
    grazing  ///< from beside a random triangle, within 1e-4 rad of its plane
};
inline constexpr std::array kRayKinds{RayKind::primary, RayKind::diffuse, RayKind::vertex,
                                      RayKind::edge,    RayKind::axis,    RayKind::grazing};

std::string_view rayKindName(RayKind kind);
std::optional<RayKind> rayKindByName(std::string_view name);

/// Makes rays. A ray is a function of (geometry, camera, image size, seed, kind, index) alone.
///
/// In single view, a ray that starts outside the view or hits outside proves nothing: origins and
/// targets are drawn anew, up to kTries times, until they lie inside.
class RaySource {
public:
    static constexpr int kTries = 256;

    /// \p geometry must outlive the source and hold at least one triangle.
    RaySource(const FrameGeometry& geometry, const Camera& camera, const GridSettings& settings,
              uint32_t seed);

    Ray primary(uint32_t index) const;

    /// The ray that leaves the surface at \p hit of primary ray \p index: its origin by
    /// offsetOrigin, its direction cosine-distributed on the side the ray came from, the primitive
    /// skipped. None where the triangle has no area.
    std::optional<Ray> diffuse(uint32_t index, const Hit& hit) const;

    /// Every second ray passes exactly through the vertex, where a float origin allows that;
    /// for the others the direction is the rounded difference.
    Ray vertex(uint32_t index) const;

    /// Every second ray passes exactly through the edge, where floats allow that.
    Ray edge(uint32_t index) const;

    /// By index mod 4: 0 and 1 start at a random point of the box, 2 passes exactly through a
    /// vertex, 3 starts with three vertices' coordinates.
    Ray axis(uint32_t index) const;

    Ray grazing(uint32_t index) const;

    /// Any kind but diffuse.
    Ray make(RayKind kind, uint32_t index) const;

private:
    RayRandom random(RayKind kind, uint32_t index) const { return {seed_, (uint32_t) kind, index}; }
    bool inside(glm::vec3 p) const;
    glm::vec3 pointInBox(RayRandom& random) const;
    const Triangle& anyTriangle(RayRandom& random) const;
    glm::vec3 anyVertex(RayRandom& random) const;

    const FrameGeometry& geometry_;
    uint32_t seed_;
    glm::vec3 lo_, hi_;          ///< the scene's box
    std::optional<View> view_;   ///< in single view
    CameraBasis basis_;          ///< world space
    double tanX_ = 0, tanY_ = 0; ///< half the image's size at depth one
};

} // namespace dirt
