#pragma once

#include "core/base/executor.h"
#include "core/grid/geometry.h"
#include "shaders/shared/shadow_map.h"

#include <vector>

namespace dirt {

/// What a texel of the shadow map holds, by definition: the depth of the nearest caster that the
/// ray from the light through its centre hits by the exact decision, or kNothingCasts. Holes let
/// the ray through.
float shadowDepth(const FrameGeometry& geometry, const GridSpotlight& light, const ShadowMap& map,
                  uint x, uint y);

/// ShadowMap: the same for all texels, row by row and bit for bit, by rasterizing the triangle
/// buffer as the light sees it. \p depths keeps its memory.
void rasterizeShadowMap(const FrameGeometry& geometry, const GridSpotlight& light,
                        const ShadowMap& map, Executor& executor, std::vector<float>& depths);

} // namespace dirt
