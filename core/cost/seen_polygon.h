#pragma once

#include "core/grid/view.h"

#include <array>

#include <glm/vec3.hpp>

namespace dirt {

/// What a view sees of a triangle: corners (x/w, y/w, w), none where it sees nothing. Plain double:
/// for estimates, not for construction.
struct SeenPolygon {
    int count = 0;
    std::array<glm::dvec3, 7> corners; ///< each of four sides adds at most one to three
    glm::dvec3 inverseDepth{0.0};      ///< 1/w = inverseDepth . (x/w, y/w, 1); 0 if edge-on

    /// Bounds of the corners; depths rounded outwards by kDepthMargin, as construction rounds them:
    /// what faces the eye squarely has a range of depths because of it, and alone in its tile lies
    /// in all bins.
    glm::dvec3 low() const;
    glm::dvec3 high() const;
    /// Area of the shadow on the plane of two coordinates.
    double area(int axis, int other) const;
};

/// Clips a triangle, in the view's frame, to |x| <= rimX w and |y| <= rimY w.
SeenPolygon seenPolygon(const std::array<glm::dvec3, 3>& triangle, double rimX, double rimY);

} // namespace dirt
