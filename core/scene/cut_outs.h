#pragma once

#include "core/scene/scene.h"

namespace dirt {

/// Whether the point at barycentric weights (\p u, \p v) of \p primitive is there: its material's
/// opacity, at the texture's full resolution, is at least 1/2.
bool isThere(const Scene& scene, uint32_t primitive, float u, float v);

} // namespace dirt
