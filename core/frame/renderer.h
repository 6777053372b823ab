#pragma once

#include "core/base/image.h"
#include "core/frame/backend.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace dirt {

/// What one frame gave.
struct RenderResult {
    Image image;                  ///< mean radiance of the finished samples
    int samples = 0;              ///< finished; fewer than asked for if the frame was stopped
    std::vector<PassTime> build;  ///< passes of the construction
    std::vector<PassTime> passes; ///< these, then each pass and event over all samples
    double frameMs = 0.0;         ///< wall time of everything
    FrameCounts counts;

    /// Sum of the times of \p name over all events.
    double passMs(const char* name) const;
};

/// Ways to look into and to end a frame while it runs. All are called on the caller's thread.
struct RenderHooks {
    std::function<void(int done, int total)> progress; ///< after each sample
    /// After each Shade, before the shift: the backend's buffers are those of the path event.
    std::function<void(uint32_t sample, int event)> observe;
    std::function<bool()> stop; ///< asked between passes: true gives up the unfinished sample
};

/// The image that a backend has summed up over \p samples, as their mean.
Image meanImage(const Backend& backend, const GridSettings& grid, int samples);

/// Renders one frame: one build, then all samples in order, each the passes of its path events.
/// The image is a pure function of scene and settings, for any number of threads.
class Renderer {
public:
    /// All arguments must outlive the renderer.
    Renderer(const Scene& scene, const RenderSettings& settings, Backend& backend);

    /// Keeps G[k-1] even where the scene does not require it, for whoever looks at the buffers.
    void keepPreviousPoint() { previousPoint_ = true; }

    /// The settings' number of samples is counted from \p sample, for whoever looks into that one.
    void beginAt(uint32_t sample) { first_ = sample; }

    RenderResult render(const RenderHooks& hooks = {});

private:
    const Scene& scene_;
    const RenderSettings& settings_;
    Backend& backend_;
    bool previousPoint_ = false;
    uint32_t first_ = 0;
};

} // namespace dirt
