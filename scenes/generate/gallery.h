#pragma once

#include "scenes/generate/mesh.h"

namespace dirt::generate {

/// What an aisle's rear wall has in one bay.
enum class BayKind { Plain, Niche, Door, Window };

/// A bay of the aisle's rear wall, its face at z = 0 looking along z, standing on y = 0.
Mesh makeWallBay(const Detail& detail, BayKind kind, double halfWidth, double height);

/// A flat pilaster with base and capital mouldings; its back is at z = 0.
Mesh makePilaster(const Detail& detail, double halfWidth, double depth, double height);

/// An urn of the given height, for niches.
Mesh makeUrn(const Detail& detail, double height);

} // namespace dirt::generate
