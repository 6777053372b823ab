#pragma once

#include "core/frame/host_backend.h"

#include <vector>

namespace dirt::test {

/// Passes all rays on to another backend, and keeps the shadow rays and their answers.
class RecordingBackend final : public HostBackend {
public:
    struct Occluded {
        std::vector<Ray> rays;
        std::vector<float> maxT;
        std::vector<uint8_t> result;
    };

    RecordingBackend(Backend& inner, Executor& executor) : HostBackend(executor), inner_(inner) {}

    std::string name() const override { return inner_.name(); }
    std::string device() const override { return inner_.device(); }
    void clear(const Camera& camera, const GridSettings& settings) override {
        camera_ = camera;
        settings_ = settings;
    }
    void fillPrimitives() override { inner_.build(*geometry_, camera_, settings_); }
    void intersect(std::span<const Ray> rays, std::span<Hit> hits) override {
        inner_.intersect(rays, hits);
    }
    void occluded(std::span<const Ray> rays, std::span<const float> maxT,
                  std::span<uint8_t> result) override {
        inner_.occluded(rays, maxT, result);
        Occluded& kept = shadows.back();
        kept.rays.insert(kept.rays.end(), rays.begin(), rays.end());
        kept.maxT.insert(kept.maxT.end(), maxT.begin(), maxT.end());
        kept.result.insert(kept.result.end(), result.begin(), result.end());
    }
    void visibility(int event) override {
        shadows.emplace_back();
        HostBackend::visibility(event);
    }

    std::vector<Occluded> shadows; ///< one entry per path event

private:
    Backend& inner_;
    Camera camera_;
    GridSettings settings_;
};

} // namespace dirt::test
