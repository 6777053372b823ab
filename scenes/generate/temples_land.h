#pragma once

#include "scenes/generate/mesh.h"

namespace dirt::generate {

/// Height of the ground at (x, z): a rocky cape with a levelled place for the temple, steep towards
/// the sea.
double groundHeight(double x, double z);

/// Level of the sea.
constexpr double seaLevel = -42;

/// The top of the next cape.
constexpr Vec3 headland(-86, seaLevel + 31, -246);

/// The ground around the origin, finest there.
void addGround(Mesh& mesh);

/// The sea, islands and coasts in the haze, and the sky.
void addFarView(Mesh& mesh);

/// A rock of about 1 m on the origin; `kind` chooses among shapes.
Mesh makeRock(const Detail& detail, std::uint32_t kind);

} // namespace dirt::generate
