#pragma once

#include <cstdint>

#include "scenes/generate/mesh.h"

namespace dirt::generate {

/// What stands about in the hangar. Everything stands on y = 0 around the origin.

/// A steel drum, 0.88 m high.
Mesh makeDrum(const Detail& detail, int material);

/// A tool chest on castors, its drawers towards +z.
Mesh makeToolChest(const Detail& detail);

/// A work platform with steps that rise towards -z; the deck is 2.1 m up.
Mesh makeWorkPlatform(const Detail& detail);

/// A radial engine on its stand, the shaft towards +z.
Mesh makeEngineStand(const Detail& detail);

/// A slatted crate.
Mesh makeCrate(const Detail& detail, Vec3 size, std::uint32_t seed);

/// Two gas bottles on a trolley.
Mesh makeGasTrolley(const Detail& detail);

/// A workbench, 3 m long, with a vice and boxes; its front towards +z.
Mesh makeWorkbench(const Detail& detail, std::uint32_t seed);

/// A pair of wheel chocks on a rope.
Mesh makeChocks(const Detail& detail);

/// A hose that lies in loose coils.
Mesh makeHose(const Detail& detail);

} // namespace dirt::generate
