#include "backend_cpu/cpu_backend.h"

#include "core/trace/traverse.h"

#include <chrono>

namespace dirt {
namespace {

/// Neighbouring rays share cells; a piece is long enough to hide the loop's cost and short enough
/// to balance threads.
constexpr size_t kRaysPerPiece = 512;

} // namespace

std::string CpuBackend::device() const {
    return std::to_string(executor_.threads()) +
           (executor_.threads() == 1 ? " thread" : " threads");
}

void CpuBackend::build(const FrameGeometry& geometry, const Camera& camera,
                       const GridSettings& settings) {
    geometry_ = &geometry;
    triangleBytes_ = geometry.triangles.size() * sizeof(Triangle);
    passes_.clear();
    const auto timed = [&](const char* pass, auto&& run) {
        const auto start = std::chrono::steady_clock::now();
        run();
        const std::chrono::duration<double, std::milli> ms =
            std::chrono::steady_clock::now() - start;
        passes_.push_back({pass, ms.count(), 0});
    };
    grid_ = {}; // before the next one is allocated
    timed("Clear", [&] { grid_ = makeEmptyGrid(camera, settings); });
    timed("FillDepth", [&] { builder_.fillDepth(geometry, grid_); });
    timed("FillDepthMipmap", [&] { builder_.fillDepthMipmap(grid_); });
    timed("FillPrimitives", [&] { builder_.fillPrimitives(geometry, grid_); });
}

void CpuBackend::trace(std::span<const Ray> rays, std::span<Hit> hits) {
    executor_.forRange(rays.size(), kRaysPerPiece, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i) hits[i] = closestHit(grid_, *geometry_, rays[i]);
    });
}

void CpuBackend::occluded(std::span<const Ray> rays, std::span<const float> maxT,
                          std::span<uint8_t> result) {
    executor_.forRange(rays.size(), kRaysPerPiece, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i)
            result[i] = anyHit(grid_, *geometry_, rays[i], maxT[i]);
    });
}

std::vector<BufferSize> CpuBackend::memory() const {
    uint64_t bounds = 0, pyramid = 0;
    for (const DepthPyramid& chain : grid_.pyramids)
        for (size_t level = 0; level < chain.levels.size(); ++level)
            (level == 0 ? bounds : pyramid) +=
                chain.levels[level].bounds.size() * sizeof(DepthBounds);
    return {{"triangle buffer", triangleBytes_},
            {"depth bounds", bounds},
            {"depth pyramid", pyramid},
            {"id buffer heads", grid_.heads.size() * sizeof(uint32_t)},
            {"id buffer", grid_.ids.size() * sizeof(uint32_t)}};
}

} // namespace dirt
