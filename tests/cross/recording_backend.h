#pragma once

#include "core/frame/backend.h"

#include <vector>

namespace dirt::test {

/// Passes everything on to another backend, and keeps the rays and their answers.
class RecordingBackend final : public Backend {
public:
    struct Traced {
        std::vector<Ray> rays;
        std::vector<Hit> hits;
    };
    struct Occluded {
        std::vector<Ray> rays;
        std::vector<float> maxT;
        std::vector<uint8_t> result;
    };

    explicit RecordingBackend(Backend& inner) : inner_(inner) {}

    std::string name() const override { return inner_.name(); }
    std::string device() const override { return inner_.device(); }
    void build(const FrameGeometry& geometry, const Camera& camera,
               const GridSettings& settings) override {
        inner_.build(geometry, camera, settings);
    }
    void trace(std::span<const Ray> rays, std::span<Hit> hits) override {
        inner_.trace(rays, hits);
        traced.push_back({{rays.begin(), rays.end()}, {hits.begin(), hits.end()}});
    }
    void occluded(std::span<const Ray> rays, std::span<const float> maxT,
                  std::span<uint8_t> result) override {
        inner_.occluded(rays, maxT, result);
        shadows.push_back({{rays.begin(), rays.end()},
                           {maxT.begin(), maxT.end()},
                           {result.begin(), result.end()}});
    }
    std::vector<PassTime> buildPasses() const override { return inner_.buildPasses(); }
    std::vector<BufferSize> memory() const override { return inner_.memory(); }
    uint64_t listEntries() const override { return inner_.listEntries(); }

    std::vector<Traced> traced;    ///< one entry per call
    std::vector<Occluded> shadows; ///< one entry per call

private:
    Backend& inner_;
};

} // namespace dirt::test
