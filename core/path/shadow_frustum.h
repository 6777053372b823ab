#pragma once

#include "core/grid/geometry.h"
#include "core/scene/light.h"
#include "core/scene/scene.h"
#include "shaders/shared/shadow_map.h"

namespace dirt {

/// Throws InputError where one perspective map cannot hold what \p light shines on.
void checkShadowMap(const Spotlight& light);

/// The shadow map of the scene's light in the grid frame: the square frustum around its cone.
/// Throws InputError like checkShadowMap.
ShadowMap makeShadowMap(const Scene& scene, const GridFrame& frame);

} // namespace dirt
