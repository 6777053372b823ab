#pragma once

#include "core/frame/backend.h"
#include "core/trace/traverse.h"

namespace dirt::test {

/// Tests every triangle: the oracle of a frame, and no structure that could be at fault.
class BruteForceBackend final : public Backend {
public:
    std::string name() const override { return "brute force"; }
    std::string device() const override { return "1 thread"; }
    void build(const FrameGeometry& geometry, const Camera&, const GridSettings&) override {
        geometry_ = &geometry;
    }
    void trace(std::span<const Ray> rays, std::span<Hit> hits) override {
        for (size_t i = 0; i < rays.size(); ++i)
            hits[i] = closestHitBruteForce(*geometry_, rays[i]);
    }
    void occluded(std::span<const Ray> rays, std::span<const float> maxT,
                  std::span<uint8_t> result) override {
        for (size_t i = 0; i < rays.size(); ++i) {
            const Hit hit = closestHitBruteForce(*geometry_, rays[i]);
            result[i] = hit.found() && hit.t < maxT[i];
        }
    }
    std::vector<PassTime> buildPasses() const override { return {{"Build", 0.0, 0}}; }
    std::vector<BufferSize> memory() const override { return {}; }
    uint64_t listEntries() const override { return 0; }

private:
    const FrameGeometry* geometry_ = nullptr;
};

} // namespace dirt::test
