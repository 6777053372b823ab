#pragma once

#include "core/grid/geometry.h"

namespace dirt {

/// Whether a ray along \p direction that meets \p primitive at the barycentric weights (\p u, \p v)
/// hits it: not where it is cut out, and a surface that is not double-sided from its front alone,
/// from which its corners are seen counterclockwise. By the exact sign, on all backends alike.
bool isHit(const FrameGeometry& geometry, glm::vec3 direction, uint32_t primitive, float u,
           float v);

} // namespace dirt
