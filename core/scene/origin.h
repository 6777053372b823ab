#pragma once

#include <limits>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

namespace dirt {

/// The box of some points; empty at first.
struct Bounds {
    glm::dvec3 low{std::numeric_limits<double>::max()};
    glm::dvec3 high{std::numeric_limits<double>::lowest()};

    void include(const glm::dvec3& p) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
};

/// What is to be taken off coordinates in \p bounds before they are rounded to float32: zero, but
/// where the largest |coordinate| exceeds the box's diagonal by more than 128. There the spacing of
/// float32, 2^-24 to 2^-23 of the coordinate, may exceed 2^-16 of the diagonal, which shows (see
/// core/frame/precision.h). Coordinates are then at most 1.5 times the box's longest edge.
///
/// It lies on a lattice whose step is the power of two above that edge, so that scenes which differ
/// by a multiple of the step, and have their middle within half a step of it, get the very same
/// coordinates; taking it off doubles is exact but for their last digits.
glm::dvec3 originFor(const Bounds& bounds);

} // namespace dirt
