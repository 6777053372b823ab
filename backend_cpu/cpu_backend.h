#pragma once

#include "backend_cpu/builder.h"
#include "core/frame/backend.h"

namespace dirt {

/// The structure built by a software rasterizer and traced on the CPU.
class CpuBackend final : public Backend {
public:
    explicit CpuBackend(Executor& executor) : executor_(executor), builder_(executor) {}

    std::string name() const override { return "cpu"; }
    std::string device() const override;

    void build(const FrameGeometry& geometry, const Camera& camera,
               const GridSettings& settings) override;
    void trace(std::span<const Ray> rays, std::span<Hit> hits) override;
    void occluded(std::span<const Ray> rays, std::span<const float> maxT,
                  std::span<uint8_t> result) override;

    std::vector<PassTime> buildPasses() const override { return passes_; }
    std::vector<BufferSize> memory() const override;
    uint64_t listEntries() const override { return grid_.ids.size(); }

    /// The structure of the last build.
    const Grid& grid() const { return grid_; }

private:
    Executor& executor_;
    GridBuilder builder_;
    const FrameGeometry* geometry_ = nullptr; ///< alive while rays are traced, no longer
    uint64_t triangleBytes_ = 0;
    Grid grid_;
    std::vector<PassTime> passes_;
};

} // namespace dirt
