#pragma once

#include "scenes/generate/mesh.h"

namespace dirt::generate {

/// A groin vault over a square bay: the soffit of two crossing barrels. The origin is the bay's
/// centre on the springing plane.
Mesh makeGroinVault(const Detail& detail, int material, double halfWidth, double rise);

/// A rib across an aisle: a half ellipse along x, `halfSpan` wide and `rise` high, hanging below
/// the vault; the rib's width is along z.
Mesh makeRib(const Detail& detail, int material, double halfSpan, double rise, double width);

} // namespace dirt::generate
