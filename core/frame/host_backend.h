#pragma once

#include "core/base/executor.h"
#include "core/frame/backend.h"
#include "core/frame/passes.h"

#include <optional>

namespace dirt {

/// A backend whose buffers lie in the host's memory: the passes of a sample are core's own, over
/// the structure that a derived class builds and traces. Without a rasterizer unless a derived
/// class brings one.
class HostBackend : public Backend {
public:
    explicit HostBackend(Executor& executor) : executor_(executor) {}

    void transform(const Mesh& mesh, const Camera& camera, ViewMode mode) override;
    void setGeometry(const FrameGeometry& geometry) override;
    void fillDepth() override {}
    void fillDepthMipmap() override {}

    bool rasterizes() const override { return false; }
    void beginFrame(const Scene& scene, const RenderSettings& settings,
                    const Requirements& requirements) override;
    void shadowMap() override;
    void beginSample() override;
    void directVisibility(uint32_t sample) override;
    void depthMask(int event) override;
    void rays(uint32_t sample, int event) override;
    void trace(int event) override;
    void fetch(int event) override;
    void visibility(int event) override;
    void shade(int event) override;
    void shift() override;
    void resolve() override;

    FrameGeometry readGeometry() const override { return *geometry_; }
    bool hasGrid() const override { return false; }
    Grid readGrid() const override;
    void writeGrid(const Grid& grid) override;
    PathBuffers readPaths() const override { return paths_.unpacked(*geometry_); }
    void writePaths(const PathBuffers& paths) override;
    PathBuffers readPath(size_t pixel) const override {
        return paths_.only(pixel).unpacked(*geometry_);
    }
    std::vector<SurfacePoint> readPoints() const override;
    std::vector<glm::vec3> readRadiance() const override { return paths_.radiance; }
    std::vector<float> readShadowMap() const override { return shadowDepths_; }
    void writeShadowMap(const std::vector<float>& depths) override { shadowDepths_ = depths; }
    std::vector<glm::vec3> readImage() const override { return paths_.image; }

    FrameCounts counts() const override { return counts_; }
    /// The triangle buffer and the paths' buffers; a derived class adds its structure's.
    std::vector<BufferSize> memory() const override;
    uint64_t listEntries() const override { return 0; }

    /// The buffers themselves; of packed points the words.
    const FrameGeometry& geometry() const { return *geometry_; }
    const PathBuffers& paths() const { return paths_; }

protected:
    Executor& executor_;
    const FrameGeometry* geometry_ = nullptr; ///< alive while it is in use, no longer
    std::optional<FrameContext> frame_;
    PathBuffers paths_;
    std::vector<float> shadowDepths_; ///< of the light's shadow map
    FrameCounts counts_;

private:
    FrameGeometry transformed_;
    uint64_t triangleBytes_ = 0;
};

} // namespace dirt
