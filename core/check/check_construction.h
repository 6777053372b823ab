#pragma once

#include "core/check/built_structure.h"
#include "core/check/check_row.h"

namespace dirt {

/// Rows of the passes of construction: \p a as \p first has built it, \p b as \p second has.
std::vector<CheckRow> checkConstruction(const BuiltStructure& a, const BuiltStructure& b,
                                        const Camera& camera, Backend& first, Backend& second);

} // namespace dirt
