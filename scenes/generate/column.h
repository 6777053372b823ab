#pragma once

#include "scenes/generate/mesh.h"

namespace dirt::generate {

/// A column's measures in metres; the capital's leaves and volutes follow from the radius.
struct ColumnShape {
    double height;  ///< from the plinth's foot to the abacus' top
    double radius;  ///< of the shaft at its foot
    double capital; ///< height of the capital
    int flutes;     ///< 0 for a smooth shaft
    double twist;   ///< turns of the flutes around the shaft
    int shaftMaterial;
    int stoneMaterial; ///< base and capital
};

/// A column on the origin: plinth, Attic base, shaft with entasis, leaf capital.
Mesh makeColumn(const Detail& detail, const ColumnShape& shape);

/// A leaf capital on the origin whose neck has the given radius, with its abacus.
Mesh makeCapital(const Detail& detail, int material, double neck, double height);

} // namespace dirt::generate
