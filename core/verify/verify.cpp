#include "core/verify/verify.h"

#include <algorithm>
#include <cfloat>
#include <chrono>

namespace dirt {

namespace {

constexpr uint64_t kBatchRays = 1 << 16;
constexpr size_t kGrain = 256; ///< rays judged or made in one piece

/// Primary rays spent per diffuse ray wanted, at most: where the camera sees next to nothing, the
/// search has to end.
constexpr uint64_t kPrimaryPerDiffuse = 16;

double millisecondsSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
        .count();
}

void count(const Judgement& judgement, BackendReport& report) {
    report.missed += judgement.grade == Grade::missed;
    report.falseHits += judgement.grade == Grade::falseHit;
    report.wrongPrimitive += judgement.grade == Grade::wrongPrimitive;
    report.maxRelativeTError = std::max(report.maxRelativeTError, judgement.relativeTError);
    report.maxUlpTError = std::max(report.maxUlpTError, judgement.ulpTError);
}

/// How far before or behind the nearest hit, relative to t: 2^-20 is far more than t's error.
constexpr double kAside = 0x1p-20;

/// Up to where a ray is asked for any hit: to the end, or to just before or behind the nearest,
/// where that is a normal float.
float limitFor(const Verdict& truth, uint32_t index) {
    const bool isNormal = truth.found() && truth.t > 0x1p-120 && truth.t < 0x1p120; // by far
    if (!isNormal || index % 3 == 0) return FLT_MAX;
    return (float) (truth.t * (index % 3 == 1 ? 1.0 - kAside : 1.0 + kAside));
}

} // namespace

Verifier::Verifier(const FrameGeometry& geometry, const Camera& camera, const GridSettings& grid,
                   std::vector<Tracer*> backends, const VerifySettings& settings,
                   Executor& executor)
    : geometry_(geometry), backends_(std::move(backends)), settings_(settings), executor_(executor),
      source_(geometry, camera, grid, settings.seed, settings.focus), scope_(grid, camera),
      judge_(geometry) {}

KindReport Verifier::run(RayKind kind) {
    KindReport report;
    report.kind = kind;
    report.backends.resize(backends_.size());
    uint64_t next = 0;
    for (uint64_t cast = 0; cast < settings_.rays;) {
        Batch batch;
        fill(kind, std::min(kBatchRays, settings_.rays - cast), next, batch);
        if (batch.rays.empty()) break;
        for (size_t b = 0; b < backends_.size(); b++) {
            batch.hits.emplace_back(batch.rays.size());
            const auto start = std::chrono::steady_clock::now();
            backends_[b]->intersect(batch.rays, batch.hits[b]);
            report.backends[b].traceMs += millisecondsSince(start);
        }
        judge(batch, select(batch, report), report);
        cast += batch.rays.size();
    }
    return report;
}

void Verifier::fill(RayKind kind, uint64_t wanted, uint64_t& next, Batch& batch) {
    if (kind == RayKind::diffuse) return fillDiffuse(wanted, next, batch);
    batch.rays.resize(wanted);
    batch.indices.resize(wanted);
    executor_.forRange(wanted, kGrain, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; i++) {
            batch.indices[i] = (uint32_t) (next + i);
            batch.rays[i] = source_.make(kind, batch.indices[i]);
        }
    });
    next += wanted;
}

void Verifier::fillDiffuse(uint64_t wanted, uint64_t& next, Batch& batch) {
    const uint64_t end = std::min<uint64_t>(settings_.rays * kPrimaryPerDiffuse, UINT32_MAX);
    while (batch.rays.size() < wanted && next < end) {
        Batch seeing;
        uint64_t seen = next;
        fill(RayKind::primary, std::min(wanted - batch.rays.size(), end - next), seen, seeing);
        std::vector<Hit> hits(seeing.rays.size());
        backends_[0]->intersect(seeing.rays, hits);
        for (size_t i = 0; i < hits.size(); i++) {
            if (!hits[i].found()) continue;
            if (const auto ray = source_.diffuse(seeing.indices[i], hits[i])) {
                batch.rays.push_back(*ray);
                batch.indices.push_back(seeing.indices[i]);
            }
        }
        next = seen;
    }
}

std::vector<uint32_t> Verifier::select(const Batch& batch, KindReport& report) const {
    std::vector<uint32_t> selected;
    uint64_t seen = report.rays + report.outside;
    for (uint32_t i = 0; i < batch.rays.size(); i++) {
        seen++;
        const bool agree = std::all_of(batch.hits.begin(), batch.hits.end(), [&](const auto& h) {
            return h[i].primitive == batch.hits[0][i].primitive;
        });
        if (!agree) {
            report.disagreed++;
        } else {
            // Spread evenly: as many as are due after this share of the rays.
            if (report.agreed * settings_.rays >= seen * settings_.agreeing) continue;
            report.agreed++;
        }
        selected.push_back(i);
    }
    report.rays += batch.rays.size();
    for (const Hit& hit : batch.hits[0]) report.hits += hit.found();
    return selected;
}

void Verifier::judge(const Batch& batch, const std::vector<uint32_t>& selected,
                     KindReport& report) {
    struct Outcome {
        Verdict truth;
        bool counts = false;
        std::vector<Judgement> judgements;
    };
    std::vector<Outcome> outcomes(selected.size());
    executor_.forRange(selected.size(), kGrain, [&](size_t begin, size_t end) {
        for (size_t s = begin; s < end; s++) {
            const Ray ray = withoutDenormals(batch.rays[selected[s]]);
            Outcome& outcome = outcomes[s];
            outcome.truth = judge_.nearest(ray);
            outcome.counts = scope_.counts(ray, outcome.truth, geometry_);
            for (const auto& hits : batch.hits)
                outcome.judgements.push_back(judge_.judge(ray, outcome.truth, hits[selected[s]]));
        }
    });
    std::vector<uint32_t> counted;
    std::vector<Verdict> truths;
    for (size_t s = 0; s < selected.size(); s++) {
        const Outcome& outcome = outcomes[s];
        if (!outcome.counts) {
            report.rays--;
            report.outside++;
            continue;
        }
        const uint32_t i = selected[s];
        counted.push_back(i);
        truths.push_back(outcome.truth);
        for (size_t b = 0; b < backends_.size(); b++)
            count(outcome.judgements[b], report.backends[b]);
        if (outcome.judgements[0].grade != Grade::right)
            keep({report.kind,
                  batch.indices[i],
                  batch.rays[i],
                  batch.hits[0][i],
                  outcome.truth,
                  outcome.judgements[0].grade,
                  {}},
                 report);
    }
    if (settings_.anyHits) judgeAnyHits(batch, counted, truths, report);
}

void Verifier::judgeAnyHits(const Batch& batch, const std::vector<uint32_t>& counted,
                            const std::vector<Verdict>& truths, KindReport& report) {
    std::vector<Ray> rays;
    std::vector<float> maxT;
    std::vector<uint8_t> given(counted.size());
    for (size_t i = 0; i < counted.size(); i++) {
        rays.push_back(batch.rays[counted[i]]);
        maxT.push_back(limitFor(truths[i], batch.indices[counted[i]]));
    }
    for (size_t b = 0; b < backends_.size(); b++) {
        backends_[b]->occluded(rays, maxT, given);
        for (size_t i = 0; i < counted.size(); i++) {
            const Verdict& truth = truths[i];
            if (truth.found() && truth.t > FLT_MAX) continue; // t as a float is not below any
            const bool right = truth.found() && truth.t < maxT[i];
            if ((given[i] != 0) == right) continue;
            const Grade grade = right ? Grade::missed : Grade::falseHit;
            count({grade}, report.backends[b]);
            if (b == 0)
                keep({report.kind, batch.indices[counted[i]], rays[i], {}, truth, grade, maxT[i]},
                     report);
        }
    }
}

void Verifier::keep(const WrongAnswer& wrong, KindReport& report) const {
    if (report.wrong.size() < settings_.shownWrongAnswers) report.wrong.push_back(wrong);
}

} // namespace dirt
