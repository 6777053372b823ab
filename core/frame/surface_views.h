#pragma once

#include "core/frame/tracer.h"

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace dirt {

/// One of the points that stand for equal shares of a model's surface.
struct SurfaceSample {
    glm::vec3 point;       ///< grid frame
    glm::vec3 front, back; ///< where rays leave it to either side, beyond what lies in its plane
    glm::dvec3 normal;     ///< unit length; from its side the corners run counter-clockwise
    uint32_t triangle;
    uint32_t material; ///< of the triangle; 0 where the mesh names none
};

/// Points spread over the triangles by area, the same for the same geometry; none where there is
/// no area.
std::vector<SurfaceSample> sampleSurface(const Mesh& mesh, const FrameGeometry& geometry);

/// How a sample is seen.
enum class Side : uint8_t { hidden, front, back };

/// How each sample is seen from one place.
using SurfaceView = std::vector<Side>;

/// The shares of the surface that \p view shows from \p side, and from either.
double shareOf(const SurfaceView& view, Side side);
double shareSeen(const SurfaceView& view);

/// What is seen of \p samples from far away in each of \p directions, which point away from the
/// model. The structure of \p tracer is that of their geometry.
std::vector<SurfaceView> viewsFrom(std::span<const glm::dvec3> directions,
                                   std::span<const SurfaceSample> samples, Tracer& tracer);

/// The same from places in the grid frame.
std::vector<SurfaceView> viewsAt(std::span<const glm::dvec3> places,
                                 std::span<const SurfaceSample> samples, Tracer& tracer);

} // namespace dirt
