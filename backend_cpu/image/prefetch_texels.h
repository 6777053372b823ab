#pragma once

#include "core/scene/scene.h"

#include <cstdint>

namespace dirt {

/// Asks for the texels of map_Kd that fetchSurface reads at the barycentric weights (\p u, \p v) of
/// \p primitive, ahead of time: most of what it waits for.
void prefetchTexels(const Scene& scene, uint32_t primitive, float u, float v);

} // namespace dirt
