#pragma once

#include "core/frame/backend.h"

#include <cstdint>

namespace dirt {

/// What a frame will take.
struct Forecast {
    double buildMs = 0.0;  ///< where memory is new, as in a program's first frame
    double sampleMs = 0.0; ///< one sample, all passes
    double frameMs = 0.0;  ///< all of the settings' samples
    double rays = 0.0;     ///< of the frame, that look for their nearest hit
    double shadowRays = 0.0;
    uint64_t memory = 0; ///< bytes of all buffers
};

/// Forecasts a frame from two samples of which most pixels go without indirect paths: a sixteenth
/// of them goes on in one and half of them in the other, in blocks, so that neighbouring rays stay
/// neighbours; their time is taken for linear in them. What rasterizes the scene costs
/// much the same for any number of pixels, and what traces does not. The build is that of a backend
/// that has built nothing yet, if \p backend has not. It then holds the structure, as after a
/// frame.
Forecast forecastFrame(const Scene& scene, const RenderSettings& settings, Backend& backend);

} // namespace dirt
