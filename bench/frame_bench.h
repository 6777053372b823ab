#pragma once

#include "backend_cpu/trace/tracer.h"
#include "bench/timing.h"
#include "core/frame/renderer.h"

#include <array>
#include <string>
#include <vector>

namespace dirt {

/// What `bench frame` times, of each side. `primary` are the hits from the eye: rasterized by ours
/// where a frame does, else traced.
/// `frame` is all of a frame of one sample and two path vertices, from the mesh to the image.
enum class FramePart { build, primary, trace, shadow, frame };
inline constexpr std::array kFrameParts{FramePart::build, FramePart::primary, FramePart::trace,
                                        FramePart::shadow, FramePart::frame};
const char* framePartName(FramePart part);

/// One side's times and memory.
struct SideReport {
    std::array<Timing, kFrameParts.size()> parts;
    uint64_t bytes = 0;
};

/// What the traversal did for one set of rays, summed.
struct WorkReport {
    uint64_t rays = 0;
    LeafCounts counts;
};

struct FrameReport {
    SideReport dirt, embree;
    Timing mortonBuild; ///< Embree's at its low quality
    /// The floor for the build: the frame's geometry read and the structure written once.
    uint64_t floorBytes = 0;
    double bytesPerMs = 0.0; ///< the memory bandwidth measured
    double floorMs() const { return (double) floorBytes / bytesPerMs; }
    uint64_t listEntries = 0;
    std::array<WorkReport, kFrameParts.size()> work; ///< none for the build
};

/// Builds and traces one frame with both backends in turn, part after part, \p rounds times after
/// one round that is not counted. Both get the same rays, those of the frame itself; \p morton
/// only builds.
FrameReport benchFrame(const Scene& scene, const RenderSettings& settings, Backend& dirt,
                       Backend& embree, Backend& morton, Executor& executor, int rounds);

} // namespace dirt
