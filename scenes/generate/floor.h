#pragma once

#include "scenes/generate/mesh.h"

namespace dirt::generate {

/// The court's inlaid marble floor within ±halfExtent around the origin, its top at y = 0.
Mesh makeCourtFloor(const Detail& detail, Vec2 halfExtent);

/// Square paving stones over a rectangle at height y, for aisles.
void addPaving(Mesh& mesh, Vec2 low, Vec2 high, double y, double tile);

} // namespace dirt::generate
