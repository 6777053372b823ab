#pragma once

#include <cstdint>

#include "scenes/generate/mesh.h"

namespace dirt::generate {

/// What stands in the bunny's corner. Everything stands on y = 0 around the origin.

/// An armchair, its seat open towards +z; 0.80 m wide.
Mesh makeArmchair(const Detail& detail);

/// A round table on a turned leg, 0.52 m high.
Mesh makeSideTable(const Detail& detail);

/// A table lamp, 0.52 m high; its bulb is 0.33 m up.
Mesh makeTableLamp(const Detail& detail);

/// A closed book that lies flat, its spine towards +z.
Mesh makeBook(const Detail& detail, int cover, Vec3 size);

/// A toy block with raised frames, 6 cm wide.
Mesh makeToyBlock(const Detail& detail, int colour);

/// A ball of six coloured gores.
Mesh makeBall(const Detail& detail, double radius);

/// A plate with three carrots.
Mesh makeCarrotPlate(const Detail& detail);

/// A pot with a leafy plant, 0.9 m high.
Mesh makeHousePlant(const Detail& detail, std::uint32_t seed);

} // namespace dirt::generate
