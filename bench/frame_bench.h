#pragma once

#include "backend_cpu/tracer.h"
#include "bench/timing.h"
#include "core/frame/renderer.h"

#include <array>
#include <string>
#include <vector>

namespace dirt {

/// What `bench frame` times, of each side.
enum class FramePart { build, primary, trace, shadow };
inline constexpr std::array kFrameParts{FramePart::build, FramePart::primary, FramePart::trace,
                                        FramePart::shadow};
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
    uint64_t listEntries = 0;
    std::array<WorkReport, kFrameParts.size()> work; ///< none for the build
};

/// Builds and traces one frame with both backends in turn, part after part, \p rounds times after
/// one round that is not counted. Both get the same rays, those of the frame itself.
FrameReport benchFrame(const Scene& scene, const RenderSettings& settings, Backend& dirt,
                       Backend& embree, Executor& executor, int rounds);

} // namespace dirt
