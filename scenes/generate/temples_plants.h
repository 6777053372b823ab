#pragma once

#include <cstdint>

#include "scenes/generate/mesh.h"

namespace dirt::generate {

/// An old olive tree, some 4.5 m high, on the origin.
Mesh makeOliveTree(const Detail& detail, std::uint32_t seed);

/// A cushion of scrub, about 0.5 m high.
Mesh makeShrub(const Detail& detail, std::uint32_t seed);

/// A tuft of dry grass, about 0.3 m high.
Mesh makeGrassTuft(const Detail& detail, std::uint32_t seed);

} // namespace dirt::generate
