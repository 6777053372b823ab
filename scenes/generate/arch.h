#pragma once

#include "scenes/generate/mesh.h"
#include "scenes/generate/sweep.h"

namespace dirt::generate {

/// A wall bay with a round arch. Its origin is the arch's centre on the springing line; x runs
/// along the wall, z towards the viewer.
struct ArchShape {
    double radius;    ///< of the opening
    double halfWidth; ///< of the bay
    double top;       ///< of the wall above the springing line
    double thickness; ///< of the wall, z from -thickness/2 to thickness/2
    int voussoirs;    ///< odd, so that one is the keystone
    int wallMaterial;
    int stoneMaterial;      ///< of every second voussoir, keystone included
    int otherStoneMaterial; ///< of those between
};

/// A free-standing bay: both faces of the wall, moulded voussoirs, keystones, spandrel discs.
Mesh makeArchBay(const Detail& detail, const ArchShape& shape, int discMaterial);

/// The wall around an arch between radius and bay rectangle, at height z of the wall's face.
void addSpandrel(Mesh& mesh, int material, double radius, double halfWidth, double top, double z,
                 bool facingBack = false);

/// Walks up a jamb from `foot` below the springing line, over the arch and down; the profile's x
/// leads away from the opening, its y towards the viewer. The first and last of `steps` sweep steps
/// are the jambs, so that the corner at the springing is met exactly.
std::function<PathFrame(double)> archPath(double radius, double foot, int steps);

} // namespace dirt::generate
