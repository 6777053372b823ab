#pragma once

#include <cstdint>

#include "scenes/generate/mesh.h"

namespace dirt::generate {

/// A terracotta pot, 0.55 m high, filled with soil, on the origin.
Mesh makePot(const Detail& detail);

/// A lemon tree grown as a standard: stem, round crown, fruit. Its foot is the origin.
Mesh makeLemonTree(const Detail& detail, std::uint32_t seed);

/// A tuft of long arching blades, like an agave.
Mesh makeAgave(const Detail& detail, std::uint32_t seed);

/// Ivy that hangs down from the origin over about `length` metres and `width` across; z leads away
/// from the wall behind it.
Mesh makeHangingIvy(const Detail& detail, double width, double length, std::uint32_t seed);

} // namespace dirt::generate
