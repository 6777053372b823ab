#pragma once

#include "core/frame/host_backend.h"
#include "core/trace/traverse.h"

namespace dirt::test {

/// Tests every triangle: the oracle of a frame, and no structure that could be at fault.
class BruteForceBackend final : public HostBackend {
public:
    explicit BruteForceBackend(Executor& executor) : HostBackend(executor) {}

    std::string name() const override { return "brute force"; }
    std::string device() const override { return "host"; }
    void clear(const Camera&, const GridSettings&) override {}
    void fillPrimitives() override {}
    void intersect(std::span<const Ray> rays, std::span<Hit> hits) override {
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
};

} // namespace dirt::test
