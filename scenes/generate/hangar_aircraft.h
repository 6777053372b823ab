#pragma once

#include "scenes/generate/mesh.h"

namespace dirt::generate {

/// An airliner of the 1930s on its three wheels, its nose towards +z, the main wheels on y = 0
/// beside the origin. Span 29 m.
Mesh makeAirliner(const Detail& detail);

/// A nine-cylinder radial engine, its shaft along z, the crankcase's middle at the origin; without
/// propeller. Radius 0.65 m.
Mesh makeRadialEngine(const Detail& detail);

/// A three-bladed propeller of the given radius turning about z, its hub at the origin.
Mesh makePropeller(const Detail& detail, double radius);

/// A wheel of the given radius on the x axis, tyre and hub.
Mesh makeWheel(const Detail& detail, double radius, double width);

} // namespace dirt::generate
