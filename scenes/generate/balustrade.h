#pragma once

#include "scenes/generate/mesh.h"

namespace dirt::generate {

/// Measures of a balustrade in metres.
struct BalustradeShape {
    double length; ///< along x, between the pedestals
    double height;
    double depth; ///< of the rail
    int material;
    int balusterMaterial;
};

/// Base, turned balusters and rail, along x around the origin, standing on y = 0.
Mesh makeBalustrade(const Detail& detail, const BalustradeShape& shape);

/// A moulded pedestal that ends a stretch of balustrade and may carry a column.
Mesh makePedestal(const Detail& detail, int material, double halfWidth, double height);

} // namespace dirt::generate
