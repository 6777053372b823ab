#pragma once

#include "core/grid/geometry.h"

#include <cstdint>
#include <span>

namespace dirt {

/// Sets \p result[i] to whether triangle i has no area, exactly.
void findWithoutArea(std::span<const Triangle> triangles, uint8_t* result);

} // namespace dirt
