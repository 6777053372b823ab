#include "core/replay/judge_hits.h"

#include "core/replay/judge_rays.h"
#include "core/trace/intersect.h"
#include "core/trace/traverse.h"
#include "core/verify/exact.h"
#include "shaders/shared/margins.h"

#include <algorithm>

namespace dirt {

namespace {

std::string idText(uint32_t primitive) {
    return primitive == kNoPrimitive ? "nothing" : "triangle " + std::to_string(primitive);
}

/// How far the given weights are from the exact ones of the point where \p ray meets \p triangle.
double weightError(const Ray& ray, const Triangle& triangle, const ExactT& t, const Hit& hit) {
    // The point times t's denominator, so that nothing is divided before the end.
    const DyadicVector a(triangle.a), o(ray.origin), d(ray.direction);
    const DyadicVector ab = DyadicVector(triangle.b) - a, ac = DyadicVector(triangle.c) - a;
    const auto along = [&](int i) { return (o[i] - a[i]) * t.denominator + d[i] * t.numerator; };
    const DyadicVector ap(along(0), along(1), along(2));
    const DyadicVector normal = cross(ab, ac);
    const Dyadic whole = dot(normal, normal) * t.denominator;
    const double u = Dyadic::quotient(dot(normal, cross(ap, ac)), whole);
    const double v = Dyadic::quotient(dot(normal, cross(ab, ap)), whole);
    return std::max(std::abs(u - hit.u), std::abs(v - hit.v));
}

class HitJudge {
public:
    HitJudge(const ReplayInput& input, const DumpedHits& event, const Judge& judge)
        : input_(input), event_(event), judge_(judge), scope_(scopeOf(input.manifest)) {}

    void judge(uint32_t pixel, JudgedPass& found) const {
        const Ray ray = flushedRay(event_.rays[pixel]);
        const Hit& hit = event_.hits[pixel];
        const Verdict truth = judge_.nearest(ray);
        if (isTraceable(ray) && !scope_.counts(ray, truth, input_.geometry)) {
            ++found.outside;
            return;
        }
        ++found.compared;
        const Judgement judgement = judge_.judge(ray, truth, hit);
        if (judgement.grade != Grade::right)
            return wrong(pixel, ray, truth, hit, judgement.grade, found);
        if (!hit.found()) {
            ++found.right;
            return;
        }
        const Triangle& triangle = input_.geometry.triangles[hit.primitive];
        if (judgement.relativeTError > kFinality)
            return found.fault("wrong t", place(pixel, hit.primitive), [&] {
                return text(pixel) + ": t of triangle " + std::to_string(hit.primitive) + " is " +
                       numberText(hit.t) + ", off by " + numberText(judgement.ulpTError) + " ulp";
            });
        const double off = weightError(ray, triangle, *intersectExactly(ray, triangle), hit);
        if (!(off <= kWeightError))
            return found.fault("wrong weights", place(pixel, hit.primitive), [&] {
                return text(pixel) + ": the weights of triangle " + std::to_string(hit.primitive) +
                       " are off by " + numberText(off);
            });
        if (event_.filed && input_.hasLists && !isListed(input_, hit))
            return found.fault("misfiled", place(pixel, hit.primitive), [&] {
                return text(pixel) + ": the record of triangle " + std::to_string(hit.primitive) +
                       " is " + misfiledText(input_, hit);
            });
        ++found.right;
        found.largestTError = std::max(found.largestTError, judgement.ulpTError);
    }

private:
    std::string text(uint32_t pixel) const { return pixelText(input_, pixel); }
    static ReplayPlace place(uint32_t pixel, uint32_t primitive) {
        ReplayPlace at;
        at.pixel = pixel;
        at.primitive = primitive;
        return at;
    }

    void wrong(uint32_t pixel, const Ray& ray, const Verdict& truth, const Hit& hit, Grade grade,
               JudgedPass& found) const {
        if (input_.hasLists &&
            closestHit(*input_.grid, input_.geometry, ray).primitive == hit.primitive) {
            ++found.inherited;
            return;
        }
        const uint32_t due = truth.found() ? truth.primitives.front() : kNoPrimitive;
        const char* sort = grade == Grade::missed     ? "missed"
                           : grade == Grade::falseHit ? "false"
                                                      : "wrong primitive";
        found.fault(sort, place(pixel, truth.found() ? due : hit.primitive), [&] {
            return text(pixel) + " has " + idText(hit.primitive) + ", where its ray hits " +
                   idText(due) + (truth.found() ? " at t " + numberText(truth.t) : "");
        });
    }

    const ReplayInput& input_;
    const DumpedHits& event_;
    const Judge& judge_;
    ViewScope scope_;
};

} // namespace

JudgedPass judgeTrace(const ReplayInput& input, const DumpedHits& event, const Judge& judge,
                      Executor& executor) {
    return judgePixels("Trace", event.event, "hit buffer", event.hits.size(),
                       HitJudge(input, event, judge), executor);
}

} // namespace dirt
