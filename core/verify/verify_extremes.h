#pragma once

#include "core/base/executor.h"
#include "core/frame/backend.h"
#include "core/verify/extremes.h"
#include "core/verify/verify.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace dirt {

/// What one backend made of a variant.
struct ExtremeBackendReport {
    BackendReport rays;            ///< of all kinds
    uint64_t nonFinitePixels = 0;  ///< of a frame of one sample
    std::optional<uint64_t> leaks; ///< in a closed box: countLeaks(), and pixels that are not black
    std::optional<uint64_t> selfShadows; ///< of a ball: countSelfShadows()

    /// Whether all is as it has to be; t within kMostUlps.
    bool right() const;
};

/// t has a relative error of 2^-28 before it is rounded once (intersect.h): half a unit in the last
/// place, and 2^-28 of at most 2^24 units.
inline constexpr double kMostUlps = 0.5 + 0x1p-4;

/// A variant, verified.
struct ExtremeReport {
    const Extreme* extreme = nullptr;
    std::string leftOut; ///< why it could not be made; empty: it was
    uint64_t triangles = 0;
    uint64_t rays = 0;                          ///< cast and counted
    uint64_t hits = 0;                          ///< that the first backend gave
    std::vector<ExtremeBackendReport> backends; ///< in the order given
    std::vector<WrongAnswer> wrong;             ///< the first few of the first backend
};

/// Makes variants of a scene and verifies each: rays by a Verifier, nearest and any hits, many of
/// them aimed at what the variant changes; a frame of one sample; closed bodies.
class ExtremeVerifier {
public:
    /// The first backend is the one under test. All must outlive the verifier. \p settings says how
    /// frames are rendered, and the structure where a variant does not. Throws InputError where the
    /// scene has no triangles.
    ExtremeVerifier(Scene scene, const RenderSettings& settings, std::vector<Backend*> backends,
                    const VerifySettings& verify, Executor& executor);

    /// \p kinds: those of the variant's that are cast.
    ExtremeReport run(const Extreme& extreme, std::span<const RayKind> kinds = kRayKinds);

private:
    void derive(const Extreme& extreme);
    /// Ids of the triangles that the variant has added; if there are none, that it has changed.
    std::vector<uint32_t> changedTriangles() const;
    void castRays(const FrameGeometry& geometry, std::span<const RayKind> kinds,
                  ExtremeReport& report);
    void renderFrame(Backend& backend, ExtremeBackendReport& report);
    void probeBody(Backend& backend, const FrameGeometry& geometry, ExtremeBackendReport& report);

    /// What variants change.
    struct Original {
        Mesh mesh;
        Camera camera;
        std::vector<Spotlight> lights;
        std::vector<Material> materials;
        glm::vec3 background;
    };

    Scene scene_; ///< as the variant at hand has it
    Original original_;
    const RenderSettings settings_;
    RenderSettings changed_; ///< by the variant at hand
    const Extreme* extreme_ = nullptr;
    std::vector<Backend*> backends_;
    VerifySettings verify_;
    Executor& executor_;
};

} // namespace dirt
