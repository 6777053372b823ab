#include "backend_cpu/cpu_backend.h"

#include "core/trace/traverse.h"

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

void CpuBackend::expectLight(const Spotlight* light) {
    light_.reset();
    if (light) light_ = *light;
}

void CpuBackend::clear(const Camera& camera, const GridSettings& settings) {
    tracer_.reset();
    lightGrid_.tree.tiles = 0; // the memory is used again
    // The large buffers are used again.
    Grid empty = makeEmptyGrid(camera, settings);
    empty.heads = std::move(grid_.heads);
    empty.ids = std::move(grid_.ids);
    empty.heads.clear();
    empty.ids.clear();
    grid_ = std::move(empty);
}

void CpuBackend::fillDepth() {
    builder_.fillDepth(*geometry_, grid_);
}

void CpuBackend::fillDepthMipmap() {
    builder_.fillDepthMipmap(grid_);
}

void CpuBackend::fillPrimitives() {
    builder_.fillPrimitives(grid_);
    makeLightGrid();
    makeLeaves();
}

void CpuBackend::makeLightGrid() {
    if (light_)
        fillLightGrid(*geometry_, *light_, executor_, lightGrid_);
    else
        lightGrid_ = {};
}

/// Only now it is known where there are holes, through which repeated triangles may show.
void CpuBackend::beginFrame(const Scene& scene, const RenderSettings& settings,
                            const Requirements& requirements) {
    HostBackend::beginFrame(scene, settings, requirements);
    if (!requirements.cutOuts || !leaves_.leavesOutRepeated) return;
    makeLightGrid();
    makeLeaves();
}

void CpuBackend::makeLeaves() {
    fillLeaves(*geometry_, grid_, executor_, leaves_);
    tracer_.emplace(*geometry_, grid_, leaves_, &lightGrid_);
}

void CpuBackend::writeGrid(const Grid& grid) {
    grid_ = grid;
    tracer_.reset();
    lightGrid_ = {}; // the rays go through what was written
}

const LeafTracer& CpuBackend::tracer() {
    if (!tracer_) makeLeaves();
    return *tracer_;
}

bool CpuBackend::tracesByDefinition() const {
    return grid_.settings.traversal != Traversal::hierarchical || grid_.settings.maxMip >= 0;
}

void CpuBackend::intersect(std::span<const Ray> rays, std::span<Hit> hits) {
    if (tracesByDefinition()) {
        executor_.forRange(rays.size(), kRaysPerPiece, [&](size_t begin, size_t end) {
            for (size_t i = begin; i < end; ++i) hits[i] = closestHit(grid_, *geometry_, rays[i]);
        });
        return;
    }
    const LeafTracer& leaves = tracer();
    executor_.forRange(rays.size(), kRaysPerPiece, [&](size_t begin, size_t end) {
        leaves.closest(rays.subspan(begin, end - begin), hits.subspan(begin, end - begin));
    });
}

void CpuBackend::occluded(std::span<const Ray> rays, std::span<const float> maxT,
                          std::span<uint8_t> result) {
    if (tracesByDefinition()) {
        executor_.forRange(rays.size(), kRaysPerPiece, [&](size_t begin, size_t end) {
            for (size_t i = begin; i < end; ++i)
                result[i] = anyHit(grid_, *geometry_, rays[i], maxT[i]);
        });
        return;
    }
    const LeafTracer& leaves = tracer();
    executor_.forRange(rays.size(), kRaysPerPiece, [&](size_t begin, size_t end) {
        const size_t count = end - begin;
        leaves.occluded(rays.subspan(begin, count), maxT.subspan(begin, count),
                        result.subspan(begin, count));
    });
}

void CpuBackend::directVisibility(uint32_t sample) {
    counts_.hits += rasterizeDirectVisibility(*frame_, executor_, sample, eyeBuffers_, paths_);
    counts_.rays += paths_.pixels();
}

void CpuBackend::fetch(int event) {
    if (frame_->settings.fetch == Fetch::raster)
        rasterFetch(*frame_, grid_, executor_, fetchBuffers_, paths_);
    else
        HostBackend::fetch(event);
}

std::vector<BufferSize> CpuBackend::memory() const {
    uint64_t bounds = 0, pyramid = 0;
    for (const DepthPyramid& chain : grid_.pyramids)
        for (size_t level = 0; level < chain.levels.size(); ++level)
            (level == 0 ? bounds : pyramid) +=
                chain.levels[level].bounds.size() * sizeof(DepthBounds);
    std::vector<BufferSize> sizes = HostBackend::memory();
    sizes.insert(sizes.begin() + 1,
                 {{"depth bounds", bounds},
                  {"depth pyramid", pyramid},
                  {"id buffer heads", grid_.heads.size() * sizeof(uint32_t)},
                  {"id buffer", grid_.ids.size() * sizeof(uint32_t)},
                  {"leaf blocks", leaves_.bytes()},
                  // What the passes of a sample need for themselves is not counted on any backend.
                  {"fragments", builder_.bytes() + lightGrid_.pieceBytes()}});
    if (!lightGrid_.empty()) sizes.push_back({"light grid", lightGrid_.bytes()});
    return sizes;
}

} // namespace dirt
