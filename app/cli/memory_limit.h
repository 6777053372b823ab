#pragma once

#include "app/cli/options.h"
#include "core/cost/footprint.h"
#include "core/frame/settings.h"
#include "core/io/memory_budget.h"
#include "core/scene/scene.h"

#include <cstdint>
#include <optional>

namespace dirt {

/// Bytes that this process may hope for: the machine's memory, or its control group's limit.
uint64_t availableMemory();

/// What a scene may take: --memory, or half of availableMemory.
uint64_t sceneMemory(const CommonOptions& options);

/// Bytes that a frame on each of the options' backends needs, as far as is known beforehand. Throws
/// InputError where that is more than \p budget has left; the line then says what asks for most of
/// it. \p footprint is there where one of them is the CPU: of the others it is known less.
uint64_t checkFrameMemory(const Scene& scene, const RenderSettings& settings,
                          const std::optional<Footprint>& footprint, const CommonOptions& options,
                          const MemoryBudget& budget);

/// Throws InputError where the image, or the structure without its lists, would need more than
/// \p available bytes; the line then names a size, or a tile size, that fits.
void checkMemory(const GridSettings& settings, uint64_t available);

} // namespace dirt
