#pragma once

#include "scenes/generate/mesh.h"

namespace dirt::generate {

/// A stone or beam between two corners, its edges bevelled and shaded round (44 triangles; a plain
/// box of 12 where the bevel would not show).
void addBlock(Mesh& mesh, int material, Vec3 low, Vec3 high, double bevel = 0.01,
              Vec2 texcoordShift = Vec2(0));

} // namespace dirt::generate
