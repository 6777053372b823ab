#pragma once

#include "core/frame/backend.h"
#include "core/frame/executor.h"
#include "core/frame/settings.h"
#include "core/io/image.h"
#include "core/scene/scene.h"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace dirt {

/// What one frame gave.
struct RenderResult {
    Image image;                  ///< mean radiance of the finished samples
    int samples = 0;              ///< finished; fewer than asked for if the frame was stopped
    std::vector<PassTime> passes; ///< the build's, then each pass and event over all samples
    double frameMs = 0.0;         ///< wall time of everything
    uint64_t rays = 0;            ///< that looked for their nearest hit
    uint64_t hits = 0;            ///< of these, that found one
    uint64_t shadowRays = 0;
    uint64_t shadingBytes = 0; ///< ray, hit and shading buffers

    /// Sum of the times of \p name over all events.
    double passMs(const char* name) const;
};

/// Rays and hits of one event of one sample, and the pixels that own them.
struct EventHits {
    uint32_t sample;
    int event;
    std::span<const uint32_t> pixels;
    std::span<const Ray> rays;
    std::span<const Hit> hits;
};

/// Ways to look into and to end a frame while it runs. All are called on the caller's thread.
struct RenderHooks {
    std::function<void(int done, int total)> progress; ///< after each sample
    std::function<void(const EventHits&)> observe;     ///< after each Trace
    std::function<bool()> stop; ///< asked between passes: true gives up the unfinished sample
};

/// Renders one frame: one build, then all samples in order, each the passes of its path events.
/// The image is a pure function of scene and settings, for any executor and number of threads.
class Renderer {
public:
    /// All arguments must outlive the renderer.
    Renderer(const Scene& scene, const RenderSettings& settings, Backend& backend,
             Executor& executor);

    RenderResult render(const RenderHooks& hooks = {});

private:
    const Scene& scene_;
    const RenderSettings& settings_;
    Backend& backend_;
    Executor& executor_;
};

} // namespace dirt
