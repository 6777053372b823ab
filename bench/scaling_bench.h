#pragma once

#include "bench/timing.h"
#include "core/base/executor.h"
#include "core/frame/backend.h"

#include <cstdint>

namespace dirt {

/// Times of one scene at one size, beside the reference's.
struct ScalingPoint {
    uint64_t triangles = 0;
    int width = 0, height = 0;
    Timing build, sample;         ///< of frames of one sample
    Timing peerBuild, peerSample; ///< the same of the reference
    uint64_t bytes = 0;           ///< all buffers of ours
};

/// Frames of one sample with both backends in turn, \p rounds times after one that is not counted.
ScalingPoint benchScaling(const Scene& scene, const RenderSettings& settings, Backend& backend,
                          Backend& peer, int rounds);

/// Least-squares exponent of y ~ x^e through positive points.
double fittedExponent(const std::vector<double>& x, const std::vector<double>& y);

} // namespace dirt
