#pragma once

#include "core/frame/settings.h"

#include <cstdint>

namespace dirt {

/// Bytes that this process may hope for: the machine's memory, or its control group's limit.
uint64_t availableMemory();

/// Throws InputError where the image, or the structure without its lists, would need more than
/// \p available bytes; the line then names a size, or a tile size, that fits.
void checkMemory(const GridSettings& settings, uint64_t available);

} // namespace dirt
