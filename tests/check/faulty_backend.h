#pragma once

#include "core/frame/forwarding_backend.h"

#include <functional>

namespace dirt::test {

/// A backend that is right but for one pass: after it, \p spoil changes what the pass has made.
struct Fault {
    std::string pass; ///< as CheckRow calls it
    int event = 0;
    std::function<void(PathBuffers&)> spoilPaths = {};
    std::function<void(Grid&)> spoilGrid = {};
    std::function<void(FrameGeometry&)> spoilGeometry = {};
    std::function<void(std::vector<float>&)> spoilShadowMap = {};
};

class FaultyBackend final : public ForwardingBackend {
public:
    FaultyBackend(Backend& inner, Fault fault)
        : ForwardingBackend(inner), fault_(std::move(fault)) {}

    std::string name() const override { return "faulty"; }

    void transform(const Mesh& mesh, const Camera& camera, ViewMode mode) override {
        inner_.transform(mesh, camera, mode);
        if (fault_.spoilGeometry) {
            geometry_ = inner_.readGeometry();
            fault_.spoilGeometry(geometry_);
            inner_.setGeometry(geometry_);
        }
    }
    void fillDepth() override {
        inner_.fillDepth();
        spoilGrid("FillDepth");
    }
    void fillDepthMipmap() override {
        inner_.fillDepthMipmap();
        spoilGrid("FillDepthMipmap");
    }
    void fillPrimitives() override {
        inner_.fillPrimitives();
        spoilGrid("FillPrimitives");
    }

    void shadowMap() override {
        inner_.shadowMap();
        if (fault_.pass != "ShadowMap") return;
        std::vector<float> depths = inner_.readShadowMap();
        fault_.spoilShadowMap(depths);
        inner_.writeShadowMap(depths);
    }
    void beginSample() override {
        inner_.beginSample();
        spoil("Clear", 0);
    }
    void directVisibility(uint32_t sample) override {
        inner_.directVisibility(sample);
        spoil("DirectVisibility", 0);
    }
    void depthMask(int k) override {
        inner_.depthMask(k);
        spoil("DepthMask", k);
    }
    void rays(uint32_t sample, int k) override {
        inner_.rays(sample, k);
        spoil("Rays", k);
    }
    void trace(int k) override {
        inner_.trace(k);
        spoil("Trace", k);
    }
    void fetch(int k) override {
        inner_.fetch(k);
        spoil("Fetch", k);
    }
    void visibility(int k) override {
        inner_.visibility(k);
        spoil("Visibility", k);
    }
    void shade(int k) override {
        inner_.shade(k);
        spoil("Shade", k);
        event_ = k;
    }
    void shift() override {
        inner_.shift();
        spoil("Shift", event_);
    }
    void resolve() override {
        inner_.resolve();
        spoil("Resolve", 0);
    }

private:
    void spoilGrid(const char* pass) {
        if (fault_.pass != pass) return;
        Grid grid = inner_.readGrid();
        fault_.spoilGrid(grid);
        inner_.writeGrid(grid);
    }
    void spoil(const char* pass, int event) {
        if (fault_.pass != pass || fault_.event != event) return;
        PathBuffers paths = inner_.readPaths();
        fault_.spoilPaths(paths);
        inner_.writePaths(paths);
    }

    Fault fault_;
    FrameGeometry geometry_; ///< spoilt
    int event_ = 0;
};

} // namespace dirt::test
