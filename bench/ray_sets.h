#pragma once

#include "core/base/executor.h"
#include "core/frame/renderer.h"

#include <vector>

namespace dirt {

/// The rays of one frame of one sample and two path events, as its passes ask for them.
struct RaySets {
    std::vector<Ray> primary; ///< from the eye, one a pixel
    std::vector<Ray> diffuse; ///< path event 1: neighbours share a surface, not a direction
    std::vector<Ray> shadow;  ///< to the light, of both events
    std::vector<float> shadowMaxT;
};

/// Renders one sample of \p scene with \p backend and keeps what it was asked. The same bits for
/// any number of threads.
RaySets makeRaySets(const Scene& scene, const RenderSettings& settings, Backend& backend,
                    Executor& executor);

} // namespace dirt
