#pragma once

#include <cstdint>

#include "scenes/generate/mesh.h"

namespace dirt::generate {

/// A stone between two corners, its edges worn round and broken by `wear` metres.
void addWornBlock(Mesh& mesh, int material, Vec3 low, Vec3 high, double wear, std::uint32_t seed);

/// A Doric column on the origin, of drums with 20 flutes.
struct DoricShape {
    double height; ///< with its capital
    double radius; ///< at the foot
    double left;   ///< part of the shaft that still stands; from 1 on it has its capital
    std::uint32_t seed;
};
Mesh makeDoricColumn(const Detail& detail, int material, const DoricShape& shape);

/// A drum that lies on the ground along x, broken at both ends.
Mesh makeFallenDrum(const Detail& detail, int material, double radius, double length,
                    std::uint32_t seed);

/// A Doric capital that stands on the origin, the radius being that of its neck.
Mesh makeDoricCapital(const Detail& detail, int material, double neck, std::uint32_t seed);

/// A ruined temple, its front towards +z with the middle of the lowest step's edge on the origin.
/// Six by ten columns; `whole` (0 to 1) is how much of it stands.
Mesh makeTemple(const Detail& detail, double whole, std::uint32_t seed);

} // namespace dirt::generate
