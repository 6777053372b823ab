#include "core/verify/verify.h"

#include <algorithm>
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
}

} // namespace

Verifier::Verifier(const FrameGeometry& geometry, const Camera& camera, const GridSettings& grid,
                   std::vector<Tracer*> backends, const VerifySettings& settings,
                   Executor& executor)
    : geometry_(geometry), backends_(std::move(backends)), settings_(settings), executor_(executor),
      source_(geometry, camera, grid, settings.seed), scope_(grid, camera), judge_(geometry) {}

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
            const Ray& ray = batch.rays[selected[s]];
            Outcome& outcome = outcomes[s];
            outcome.truth = judge_.nearest(ray);
            outcome.counts = scope_.counts(ray, outcome.truth, geometry_);
            for (const auto& hits : batch.hits)
                outcome.judgements.push_back(judge_.judge(ray, outcome.truth, hits[selected[s]]));
        }
    });
    for (size_t s = 0; s < selected.size(); s++) {
        const Outcome& outcome = outcomes[s];
        if (!outcome.counts) {
            report.rays--;
            report.outside++;
            continue;
        }
        for (size_t b = 0; b < backends_.size(); b++)
            count(outcome.judgements[b], report.backends[b]);
        if (outcome.judgements[0].grade == Grade::right) continue;
        if (report.wrong.size() >= settings_.shownWrongAnswers) continue;
        const uint32_t i = selected[s];
        report.wrong.push_back({report.kind, batch.indices[i], batch.rays[i], batch.hits[0][i],
                                outcome.truth, outcome.judgements[0].grade});
    }
}

} // namespace dirt
