#pragma once

#include "backend_gl/programs.h"

#include <string>

namespace dirt {

/// Whether the shader stages compute as G7 asks: floats and doubles rounded to nearest, no product
/// fused with a sum; and whether doubles are divided as IEEE 754 has it. Gives the stages that do
/// not, separated by commas; empty if all is well.
std::string arithmeticFaults(Programs& programs);

} // namespace dirt
