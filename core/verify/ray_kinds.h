#pragma once

#include "core/grid/geometry.h"
#include "core/grid/settings.h"
#include "core/grid/view.h"
#include "core/trace/ray.h"
#include "core/verify/random.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace dirt {

/// The rays that `verify` casts, in the grid frame.
enum class RayKind {
    primary, ///< from the eye, through random image points
    diffuse, ///< from surface points that primary rays see, cosine-distributed
    vertex,  ///< from random points of the scene's box to a random vertex
    edge,    ///< likewise, to a random point of a random edge
    axis,    ///< along a coordinate axis, from random points or with vertices' coordinates
    grazing, ///< from beside a random triangle, within 1e-4 rad of its plane
    plane,   ///< in the plane of a random triangle, exactly where floats allow that
    border,  ///< on the borders and corners of tiles, exactly
    wild     ///< like another kind's, of any length; with zeros of both signs, denormals, NaN
};
inline constexpr std::array kRayKinds{RayKind::primary, RayKind::diffuse, RayKind::vertex,
                                      RayKind::edge,    RayKind::axis,    RayKind::grazing,
                                      RayKind::plane,   RayKind::border,  RayKind::wild};

std::string_view rayKindName(RayKind kind);
std::optional<RayKind> rayKindByName(std::string_view name);
/// "primary,diffuse, ..."
std::string rayKindNames();

/// The ray as backends take it: zeros in place of denormals (G7). Negative zeros stay.
Ray withoutDenormals(Ray ray);

/// Makes rays. A ray is a function of (geometry, camera, image size, seed, kind, index) alone.
///
/// In single view, a ray that starts outside the view or hits outside proves nothing: origins and
/// targets are drawn anew, up to kTries times, until they lie inside.
class RaySource {
public:
    static constexpr int kTries = 256;

    /// \p geometry must outlive the source and hold at least one triangle. Where a ray is aimed at
    /// a triangle, it is every second time one of \p focus, if there are any.
    RaySource(const FrameGeometry& geometry, const Camera& camera, const GridSettings& settings,
              uint32_t seed, std::vector<uint32_t> focus = {});

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

    /// Along an edge, or a power of two of it, from a corner or from beside it.
    Ray plane(uint32_t index) const;

    /// By index mod 4: 0 starts on a border and stays in its plane, 1 runs along a corner of tiles,
    /// so through the eye or from it, 2 starts on a border and leaves it, 3 passes exactly through
    /// a corner, where a float origin allows that.
    Ray border(uint32_t index) const;

    /// By index mod 8: 0 to 4 are rays of another kind with a direction as long as any float, 5 has
    /// a denormal in its direction, 6 nothing else there, 7 a NaN or an infinity anywhere.
    Ray wild(uint32_t index) const;

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
    std::vector<uint32_t> focus_;
    glm::vec3 lo_, hi_;          ///< the scene's box
    std::vector<View> views_;    ///< of the grid
    std::optional<View> view_;   ///< in single view
    CameraBasis basis_;          ///< world space
    double tanX_ = 0, tanY_ = 0; ///< half the image's size at depth one
};

} // namespace dirt
