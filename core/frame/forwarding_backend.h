#pragma once

#include "core/frame/backend.h"

namespace dirt {

/// Passes everything on to another backend, which must outlive it: for those that look at, or
/// meddle with, single passes.
class ForwardingBackend : public Backend {
public:
    explicit ForwardingBackend(Backend& inner) : inner_(inner) {}

    std::string name() const override { return inner_.name(); }
    std::string device() const override { return inner_.device(); }
    bool isIeee() const override { return inner_.isIeee(); }

    void expectLight(const Spotlight* light) override { inner_.expectLight(light); }
    void clear(const Camera& camera, const GridSettings& settings) override {
        inner_.clear(camera, settings);
    }
    void transform(const Mesh& mesh, const Camera& camera, ViewMode mode) override {
        inner_.transform(mesh, camera, mode);
    }
    void setGeometry(const FrameGeometry& geometry) override { inner_.setGeometry(geometry); }
    void fillDepth() override { inner_.fillDepth(); }
    void fillDepthMipmap() override { inner_.fillDepthMipmap(); }
    void fillPrimitives() override { inner_.fillPrimitives(); }

    void intersect(std::span<const Ray> rays, std::span<Hit> hits) override {
        inner_.intersect(rays, hits);
    }
    void occluded(std::span<const Ray> rays, std::span<const float> maxT,
                  std::span<uint8_t> result) override {
        inner_.occluded(rays, maxT, result);
    }

    bool rasterizes() const override { return inner_.rasterizes(); }
    void beginFrame(const Scene& scene, const RenderSettings& settings,
                    const Requirements& requirements) override {
        inner_.beginFrame(scene, settings, requirements);
    }
    void shadowMap() override { inner_.shadowMap(); }
    void beginSample() override { inner_.beginSample(); }
    void directVisibility(uint32_t sample) override { inner_.directVisibility(sample); }
    void depthMask(int event) override { inner_.depthMask(event); }
    void rays(uint32_t sample, int event) override { inner_.rays(sample, event); }
    void trace(int event) override { inner_.trace(event); }
    void fetch(int event) override { inner_.fetch(event); }
    void visibility(int event) override { inner_.visibility(event); }
    void shade(int event) override { inner_.shade(event); }
    void shift() override { inner_.shift(); }
    void resolve() override { inner_.resolve(); }

    FrameGeometry readGeometry() const override { return inner_.readGeometry(); }
    bool hasGrid() const override { return inner_.hasGrid(); }
    Grid readGrid() const override { return inner_.readGrid(); }
    void writeGrid(const Grid& grid) override { inner_.writeGrid(grid); }
    PathBuffers readPaths() const override { return inner_.readPaths(); }
    void writePaths(const PathBuffers& paths) override { inner_.writePaths(paths); }
    PathBuffers readPath(size_t pixel) const override { return inner_.readPath(pixel); }
    std::vector<SurfacePoint> readPoints() const override { return inner_.readPoints(); }
    std::vector<glm::vec3> readRadiance() const override { return inner_.readRadiance(); }
    std::vector<float> readShadowMap() const override { return inner_.readShadowMap(); }
    void writeShadowMap(const std::vector<float>& depths) override {
        inner_.writeShadowMap(depths);
    }
    std::vector<glm::vec3> readImage() const override { return inner_.readImage(); }

    void beginTimedPass() override { inner_.beginTimedPass(); }
    void endTimedPass() override { inner_.endTimedPass(); }
    std::vector<double> takePassTimes() override { return inner_.takePassTimes(); }

    FrameCounts counts() const override { return inner_.counts(); }
    std::vector<BufferSize> memory() const override { return inner_.memory(); }
    uint64_t listEntries() const override { return inner_.listEntries(); }

protected:
    Backend& inner_;
};

} // namespace dirt
