#pragma once

#include "scenes/generate/mesh.h"

namespace dirt::generate {

/// Measures of the entablature that runs around the court, facing inwards.
struct EntablatureShape {
    Vec2 halfExtent; ///< of the walls' faces below it
    double low;
    double high;
    double projection;
    bool brackets; ///< scrolled brackets carry the cornice, else dentils
};

/// Architrave, frieze, dentils or brackets, cornice.
void addEntablature(Mesh& mesh, const EntablatureShape& shape);

/// The tiled roof around the court, rising outwards from the eaves.
void addRoof(Mesh& mesh, Vec2 eaves, double width, double low, double rise);

} // namespace dirt::generate
