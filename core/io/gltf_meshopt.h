#pragma once

#include "core/io/json_value.h"
#include "core/io/memory_budget.h"

#include <cstddef>
#include <span>
#include <string>

namespace dirt {

/// The bytes of a buffer view that EXT_meshopt_compression compressed into \p bytes, as \p source,
/// the extension's object, says. Throws InputError where it is malformed or damaged, or would
/// unpack to more than its size can hold; and everywhere where this program was built without
/// meshoptimizer. \p memory takes what they need.
std::string decodeMeshopt(const JsonValue& source, std::span<const std::byte> bytes,
                          MemoryClaim& memory);

} // namespace dirt
