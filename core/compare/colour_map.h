#pragma once

#include <cstdint>

#include <glm/vec3.hpp>

namespace dirt {

/// False colour of a value in [0, 1], as 8-bit sRGB: from black through purple, red and orange to a
/// pale yellow. Lightness grows evenly with the value, so it can be read without colours, too.
glm::u8vec3 falseColour(double value);

} // namespace dirt
