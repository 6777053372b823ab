#pragma once

#include "core/frame/backend.h"

#include <cstdint>

namespace dirt {

/// What a frame will take.
struct Forecast {
    double buildMs = 0.0;  ///< where memory is new, as in a program's first frame
    double sampleMs = 0.0; ///< one sample, all its passes
    double frameMs = 0.0;  ///< build, shadow map, and all of the settings' samples
    double rays = 0.0;     ///< of the frame, that look for their nearest hit
    double shadowRays = 0.0;
    uint64_t memory = 0; ///< bytes of all buffers
};

/// Forecasts a frame from its first sample, which is run: the others are taken to be like it. (From
/// a part of the paths one would have to guess how each pass grows with them.) The build is that of
/// a backend that has built nothing yet, if \p backend has not. It then holds the structure and the
/// paths, as after a frame.
Forecast forecastFrame(const Scene& scene, const RenderSettings& settings, Backend& backend);

} // namespace dirt
