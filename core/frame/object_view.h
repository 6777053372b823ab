#pragma once

#include "core/frame/model_kind.h"

#include <array>
#include <span>

#include <glm/vec3.hpp>

namespace dirt {

/// Level directions around the upward one.
struct Horizon {
    glm::dvec3 right, up, forward; ///< orthonormal; Y up has X to the right and looks along -Z,
                                   ///<   Z up looks along Y

    explicit Horizon(glm::vec3 upward);
    /// Turned to the right by \p turn radians from forward.
    glm::dvec3 heading(double turn) const;
};

/// Rise of a view from slightly above: a third of the way.
inline constexpr double kSlightly = 1.0 / 3.0;

/// The direction in which an object is looked at. Sideways it is that from in front, if a level
/// view from there shows at least half of what the best level view shows of the area that its
/// outside fills in the picture, and more than half of the number of materials; else that of the
/// best of eight. In height it is the first of slightly above, halfway up, slightly below and
/// halfway below that shows as much of the best: a floor is looked at from halfway up, a ceiling
/// from below, unless a view from above shows as much where either side counts: one looks into a
/// tray.
glm::dvec3 objectDirection(const Horizon& horizon, const ModelKind& kind,
                           std::span<const SurfaceSample> samples, Tracer& tracer);

} // namespace dirt
