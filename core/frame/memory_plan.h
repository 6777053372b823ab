#pragma once

#include "core/frame/requirements.h"
#include "core/frame/settings.h"
#include "core/scene/camera.h"

#include <cstdint>
#include <string>
#include <vector>

namespace dirt {

/// A buffer, its size, and why a frame has it.
struct PlannedBuffer {
    std::string name;
    uint64_t bytes = 0;
    std::string reason;
};

/// The buffers of the structure. \p listEntries is known once the structure has been built: the id
/// buffer's size depends on nothing else.
std::vector<PlannedBuffer> planStructure(const GridSettings& settings, const Camera& camera,
                                         uint64_t triangles, uint64_t listEntries);

/// The buffers of the paths, as PathBuffers::allocate makes them, and the light's shadow map.
std::vector<PlannedBuffer> planPaths(const Requirements& requirements,
                                     const GridSettings& settings);

} // namespace dirt
