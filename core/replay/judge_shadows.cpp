#include "core/replay/judge_shadows.h"

#include "core/replay/judge_rays.h"
#include "core/trace/intersect.h"
#include "core/trace/traverse.h"
#include "core/verify/exact.h"
#include "shaders/shared/margins.h"

namespace dirt {

namespace {

/// Whether something at an exact \p t is before \p tMax. In between: as t is rounded.
enum class Before { certainly, perhaps, no };

Before before(double t, float tMax) {
    // t is rounded, too, from the exact value: by far less.
    const double kError = kFinality + 0x1p-48;
    if (t * (1.0 + kError) < tMax) return Before::certainly;
    return t * (1.0 - kError) < tMax ? Before::perhaps : Before::no;
}

class ShadowJudge {
public:
    ShadowJudge(const ReplayInput& input, const DumpedShadows& shadows, const Judge& judge)
        : input_(input), shadows_(shadows), judge_(judge), scope_(scopeOf(input.manifest)) {}

    void judge(uint32_t pixel, JudgedPass& found) const {
        const Ray ray = flushedRay(shadows_.rays[pixel]);
        const bool occluded = shadows_.occluded[pixel] != 0;
        const Verdict truth = judge_.nearest(ray);
        const Before due = truth.found() ? before(truth.t, shadows_.tMax[pixel]) : Before::no;
        if (due != Before::no && isTraceable(ray) && !scope_.counts(ray, truth, input_.geometry)) {
            ++found.outside;
            return;
        }
        ++found.compared;
        if (due != Before::perhaps && occluded != (due == Before::certainly))
            wrong(pixel, ray, truth, found);
        else if (shadows_.named)
            judgeBlocker(pixel, ray, found);
        else
            ++found.right;
    }

private:
    static ReplayPlace place(uint32_t pixel, uint32_t primitive) {
        ReplayPlace at;
        at.pixel = pixel;
        at.primitive = primitive;
        return at;
    }
    std::string text(uint32_t pixel) const { return pixelText(input_, pixel); }

    void wrong(uint32_t pixel, const Ray& ray, const Verdict& truth, JudgedPass& found) const {
        const bool occluded = shadows_.occluded[pixel] != 0;
        if (input_.hasLists &&
            anyHit(*input_.grid, input_.geometry, ray, shadows_.tMax[pixel]) == occluded) {
            ++found.inherited;
            return;
        }
        const Hit& blocker = shadows_.blockers[pixel];
        if (occluded)
            return found.fault("false occlusion", place(pixel, blocker.primitive), [&] {
                return text(pixel) + " is occluded" +
                       (blocker.found() ? " by triangle " + std::to_string(blocker.primitive)
                                        : "") +
                       ", where nothing is between it and the light";
            });
        const uint32_t due = truth.primitives.front();
        found.fault("missed occlusion", place(pixel, due), [&] {
            return text(pixel) + " is not occluded, where triangle " + std::to_string(due) +
                   " is between it and the light, at t " + numberText(truth.t);
        });
    }

    bool isBetween(const Ray& ray, uint32_t primitive, float tMax) const {
        const auto t = intersectExactly(ray, input_.geometry.triangles[primitive]);
        return t && primitive != ray.skip && before(t->toDouble(), tMax) != Before::no;
    }

    /// Of a ray whose answer is right.
    void judgeBlocker(uint32_t pixel, const Ray& ray, JudgedPass& found) const {
        const bool occluded = shadows_.occluded[pixel] != 0;
        const Hit& blocker = shadows_.blockers[pixel];
        const auto words = [&](const std::string& what) {
            return text(pixel) + ": its blocker, triangle " + std::to_string(blocker.primitive) +
                   ", is " + what;
        };
        if (occluded && !blocker.found())
            return found.fault("wrong blocker", place(pixel, kNoPrimitive),
                               [&] { return text(pixel) + " is occluded, and has no blocker"; });
        if (blocker.found() &&
            (!occluded || !isBetween(ray, blocker.primitive, shadows_.tMax[pixel])))
            return found.fault("wrong blocker", place(pixel, blocker.primitive),
                               [&] { return words("not between it and the light"); });
        if (blocker.found() && shadows_.filed && input_.hasLists && !isListed(input_, blocker))
            return found.fault("misfiled", place(pixel, blocker.primitive),
                               [&] { return words(misfiledText(input_, blocker)); });
        ++found.right;
    }

    const ReplayInput& input_;
    const DumpedShadows& shadows_;
    const Judge& judge_;
    ViewScope scope_;
};

} // namespace

JudgedPass judgeVisibility(const ReplayInput& input, const DumpedShadows& shadows,
                           const Judge& judge, Executor& executor) {
    return judgePixels("Visibility", shadows.event, "shadow rays", shadows.rays.size(),
                       ShadowJudge(input, shadows, judge), executor);
}

} // namespace dirt
