#pragma once

#include "core/check/built_structure.h"
#include "core/check/check_row.h"
#include "core/scene/scene.h"

#include <vector>

namespace dirt {

/// What one backend has made of a sample, while another ran every pass beside it.
struct SampleCheck {
    std::vector<CheckRow> rows;
    std::vector<uint32_t> surfaces;  ///< primitive that each pixel sees first
    std::vector<glm::vec3> radiance; ///< of the sample
};

/// Renders the first sample on \p source, in the structure \p built, and runs each of its passes on
/// \p tested as well, from the buffers that \p source had before the pass. A row for each buffer
/// that the pass writes, and one in the end for all those that passes have to leave alone.
SampleCheck checkPaths(const Scene& scene, const RenderSettings& settings,
                       const BuiltStructure& built, Backend& source, Backend& tested);

} // namespace dirt
