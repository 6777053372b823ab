#pragma once

#include "core/scene/srgb.h"

#include <glm/vec3.hpp>

namespace dirt {

// Colour spaces of FLIP (Andersson et al. 2020, section 4.1), from linear Rec.709 in [0, 1].
// White is D65 with the chromaticity (0.31271, 0.32902).

/// Opponent space YCxCz: a linear form of CIELab, in which spatial filters act.
glm::dvec3 linearToOpponent(glm::dvec3 rgb);
glm::dvec3 opponentToLinear(glm::dvec3 opponent);

/// CIELab, perceptually uniform: L* in [0, 100].
glm::dvec3 linearToLab(glm::dvec3 rgb);

/// Hunt's effect: chroma counts in proportion to lightness.
glm::dvec3 huntAdjusted(glm::dvec3 lab);

/// HyAB: lightness and chroma differ by their own distances, which are added.
double hyab(glm::dvec3 lab, glm::dvec3 other);

} // namespace dirt
