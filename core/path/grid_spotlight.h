#pragma once

#include "core/grid/geometry.h"
#include "core/scene/light.h"
#include "shaders/shared/spotlight.h"

namespace dirt {

/// \p light in the grid frame; sampleSpotlight() says what a point receives of it.
GridSpotlight makeGridSpotlight(const Spotlight& light, const GridFrame& frame);

} // namespace dirt
