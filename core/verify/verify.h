#pragma once

#include "core/base/executor.h"
#include "core/frame/tracer.h"
#include "core/verify/judge.h"
#include "core/verify/ray_kinds.h"
#include "core/verify/view_scope.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace dirt {

/// What one backend made of the rays of one kind.
struct BackendReport {
    uint64_t missed = 0;
    uint64_t falseHits = 0;
    uint64_t wrongPrimitive = 0;
    double maxRelativeTError = 0.0; ///< over the judged rays whose given primitive is hit
    double maxUlpTError = 0.0;      ///< likewise, in units in the last place
    double traceMs = 0.0;

    uint64_t errors() const { return missed + falseHits + wrongPrimitive; }
};

/// One answer of the first backend that was judged wrong.
struct WrongAnswer {
    RayKind kind = RayKind::primary;
    uint32_t index = 0; ///< of the ray in its kind
    Ray ray;
    Hit given;
    Verdict truth;
    Grade grade = Grade::right;
    std::optional<float> maxT; ///< it was asked only whether anything is hit before
};

/// The rays of one kind, cast through every backend.
struct KindReport {
    RayKind kind = RayKind::primary;
    uint64_t rays = 0;      ///< cast and counted
    uint64_t hits = 0;      ///< given by the first backend, of all that were cast
    uint64_t outside = 0;   ///< cast and not counted: single view does not answer for them
    uint64_t disagreed = 0; ///< the backends give different primitives; all judged
    uint64_t agreed = 0;    ///< judged of those on which they agree
    std::vector<BackendReport> backends; ///< in the order given
    std::vector<WrongAnswer> wrong;      ///< the first few of the first backend
};

struct VerifySettings {
    uint32_t rays = 1'000'000;      ///< of each kind
    uint32_t agreeing = 10'000;     ///< judged of those on which all backends agree, per kind
    uint32_t shownWrongAnswers = 5; ///< kept in KindReport::wrong
    uint32_t seed = 0;
    std::vector<uint32_t> focus{}; ///< triangles that more rays are aimed at (RaySource)
    bool anyHits = false; ///< judged rays are also asked whether they hit anything before some t
};

/// Casts rays through backends and lets exact arithmetic decide who is right.
class Verifier {
public:
    /// The backends must have been built over \p geometry with \p camera and \p grid; all must
    /// outlive the verifier. The first is the one under test: it also finds the surface points
    /// that diffuse rays start from.
    Verifier(const FrameGeometry& geometry, const Camera& camera, const GridSettings& grid,
             std::vector<Tracer*> backends, const VerifySettings& settings, Executor& executor);

    /// Every ray on which two backends give different primitives is judged, and evenly spread
    /// over the others `agreeing` more. Where no triangle is seen there are no diffuse rays, and
    /// where few are seen fewer.
    KindReport run(RayKind kind);

private:
    /// Rays of one kind that are cast together.
    struct Batch {
        std::vector<uint32_t> indices;
        std::vector<Ray> rays;
        std::vector<std::vector<Hit>> hits; ///< of each backend
    };

    void fill(RayKind kind, uint64_t wanted, uint64_t& next, Batch& batch);
    void fillDiffuse(uint64_t wanted, uint64_t& next, Batch& batch);
    /// Positions in the batch of the rays to judge.
    std::vector<uint32_t> select(const Batch& batch, KindReport& report) const;
    void judge(const Batch& batch, const std::vector<uint32_t>& selected, KindReport& report);
    /// Asks the rays of \p batch at \p counted, of which \p truths is known, for any hit.
    void judgeAnyHits(const Batch& batch, const std::vector<uint32_t>& counted,
                      const std::vector<Verdict>& truths, KindReport& report);
    void keep(const WrongAnswer& wrong, KindReport& report) const;

    const FrameGeometry& geometry_;
    std::vector<Tracer*> backends_;
    VerifySettings settings_;
    Executor& executor_;
    RaySource source_;
    ViewScope scope_;
    Judge judge_;
};

} // namespace dirt
