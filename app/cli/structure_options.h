#pragma once

#include "app/cli/input.h"

#include <string>

namespace dirt {

/// The options, each after a blank, that make the same structure of the same scene again: whatever
/// shapes it, said or not.
std::string structureOptions(const Input& input);

} // namespace dirt
