#pragma once

#include "core/frame/host_backend.h"

#include <memory>

namespace dirt {

/// What decides that a ray hits a triangle which Embree proposes.
enum class EmbreeDecision {
    core, ///< core's exact test, which also gives t and barycentrics; ties to the lowest id
    plain ///< Embree alone: what a user of Embree gets
};

/// How much work Embree puts into its tree: its default, or the least (by Morton codes).
enum class EmbreeQuality { standard, low };

/// Embree 3 as a reference: a scene of one triangle geometry over the frame's triangle buffer,
/// built anew each time, by default at Embree's default quality, on as many threads as the executor
/// has.
///
/// Under EmbreeDecision::core, of the triangles that Embree proposes along the ray those that the
/// exact test refuses are dropped, and the smallest (t, id) is the hit; what Embree fails to
/// propose stays missed. Under either, the origin's triangle and those with the same vertices are
/// not hit, and rays with NaN or infinity, or from beyond what Embree takes, hit nothing. In single
/// view rays do not end at the view's borders.
class EmbreeBackend final : public HostBackend {
public:
    /// \p robust sets RTC_SCENE_FLAG_ROBUST. Throws CapabilityError if Embree does not start.
    explicit EmbreeBackend(Executor& executor, bool robust = false,
                           EmbreeDecision decision = EmbreeDecision::core,
                           EmbreeQuality quality = EmbreeQuality::standard);
    ~EmbreeBackend() override;

    std::string name() const override;
    std::string device() const override;
    void clear(const Camera& camera, const GridSettings& settings) override;
    /// Embree's build.
    void fillPrimitives() override;
    void intersect(std::span<const Ray> rays, std::span<Hit> hits) override;
    void occluded(std::span<const Ray> rays, std::span<const float> maxT,
                  std::span<uint8_t> result) override;
    std::vector<BufferSize> memory() const override;

private:
    struct State;

    bool robust_;
    EmbreeDecision decision_;
    EmbreeQuality quality_;
    std::unique_ptr<State> state_;
};

} // namespace dirt
