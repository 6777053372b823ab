#pragma once

#include "backend_cpu/build/builder.h"
#include "backend_cpu/image/direct_visibility.h"
#include "backend_cpu/image/raster_fetch.h"
#include "backend_cpu/trace/leaves.h"
#include "backend_cpu/trace/tracer.h"
#include "core/frame/host_backend.h"

#include <optional>

namespace dirt {

/// The structure built by a software rasterizer and traced on the CPU.
class CpuBackend final : public HostBackend {
public:
    explicit CpuBackend(Executor& executor) : HostBackend(executor), builder_(executor) {}

    std::string name() const override { return "cpu"; }
    std::string device() const override;

    void expectLight(const Spotlight* light) override;
    void beginFrame(const Scene& scene, const RenderSettings& settings,
                    const Requirements& requirements) override;
    void clear(const Camera& camera, const GridSettings& settings) override;
    void fillDepth() override;
    void fillDepthMipmap() override;
    void fillPrimitives() override;

    void intersect(std::span<const Ray> rays, std::span<Hit> hits) override;
    void occluded(std::span<const Ray> rays, std::span<const float> maxT,
                  std::span<uint8_t> result) override;

    bool rasterizes() const override { return true; }
    void directVisibility(uint32_t sample) override;
    void fetch(int event) override;

    bool hasGrid() const override { return true; }
    Grid readGrid() const override { return grid_; }
    void writeGrid(const Grid& grid) override;
    std::vector<BufferSize> memory() const override;
    uint64_t listEntries() const override { return grid_.ids.size(); }

    /// The structure of the last build.
    const Grid& grid() const { return grid_; }
    /// Traces the structure; made anew where the grid was written from outside.
    const LeafTracer& tracer();

private:
    /// The leaves' walk goes tile by tile, whatever the pyramid: where a traversal is asked for by
    /// name, core's own traces.
    bool tracesByDefinition() const;
    /// The traced form of the lists.
    void makeLeaves();
    void makeLightGrid();

    GridBuilder builder_;
    Grid grid_;
    Leaves leaves_;
    std::optional<Spotlight> light_; ///< that rays are expected to end in
    LightGrid lightGrid_;
    EyeBuffers eyeBuffers_;
    FetchBuffers fetchBuffers_;
    std::optional<LeafTracer> tracer_; ///< none: the leaves are not those of the grid
};

} // namespace dirt
