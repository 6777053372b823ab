#pragma once

#include "core/grid/coverage.h"

#include <glm/vec2.hpp>

namespace dirt {

/// The values of a triangle's edges at the corners of a tile between the slopes \p s and \p t, as
/// tile_clip.h takes them: [4 k + c] is edge k at corner c, in the order (s0,t0), (s1,t0), (s0,t1),
/// (s1,t1). Relative error at most 2^-26, exact signs.
void edgesAtCorners(const ViewTriangle& triangle, glm::vec2 s, glm::vec2 t, double (&e)[12]);

} // namespace dirt
