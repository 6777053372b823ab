#pragma once

#include <glm/vec3.hpp>

namespace dirt {

/// Exact determinants of float32 inputs, as the double nearest to the true value: relative error
/// at most 2^-50, the exact sign, and zero only where the true value is zero.

/// d . ((b - o) x (c - o)): the side of line (o, d) on which edge bc lies.
double edgeDeterminantExact(glm::vec3 o, glm::vec3 d, glm::vec3 b, glm::vec3 c);

/// (p - a) . ((b - a) x (c - a)): the side of plane abc on which p lies.
double planeDeterminantExact(glm::vec3 p, glm::vec3 a, glm::vec3 b, glm::vec3 c);

/// d . ((b - a) x (c - a)).
double directionDeterminantExact(glm::vec3 d, glm::vec3 a, glm::vec3 b, glm::vec3 c);

/// Exact signs (-1, 0, 1) of the two determinants above; double arithmetic where that suffices.
int planeSide(glm::vec3 p, glm::vec3 a, glm::vec3 b, glm::vec3 c);
int directionSide(glm::vec3 d, glm::vec3 a, glm::vec3 b, glm::vec3 c);

} // namespace dirt
