#pragma once

#include "core/cost/footprint.h"
#include "core/frame/requirements.h"
#include "core/frame/settings.h"

#include <cstdint>

namespace dirt {

/// What a frame on the CPU takes, its passes' own memory included, without building it.
struct MemoryForecast {
    uint64_t structure = 0; ///< grows with tiles and bins
    uint64_t geometry = 0;  ///< grows with the triangles
    uint64_t paths = 0;     ///< grows with the pixels

    uint64_t total() const { return structure + geometry + paths; }
};

/// About as much as a frame allocates at its peak: from \p footprint, whose views are those of the
/// settings. Within a factor of two; see the test.
MemoryForecast forecastMemory(const Footprint& footprint, uint64_t triangles,
                              const RenderSettings& settings, const Requirements& requirements);

} // namespace dirt
