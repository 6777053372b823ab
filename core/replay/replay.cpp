#include "core/replay/replay.h"

#include "core/base/error.h"
#include "core/replay/judge_hits.h"
#include "core/replay/judge_shadows.h"
#include "core/replay/judge_structure.h"

#include <algorithm>
#include <limits>

namespace dirt {

std::vector<JudgedPass> judgeDump(const ReplayInput& input, Executor& executor) {
    const Manifest& manifest = input.manifest;
    std::vector<JudgedPass> passes;
    if (input.grid) passes.push_back(judgeFillDepth(input, executor));
    if (input.hasPyramid) passes.push_back(judgeFillDepthMipmap(input));
    if (input.hasLists) passes.push_back(judgeFillPrimitives(input, executor));
    if (manifest.atEye) passes.push_back(judgeAtEye(input));
    if ((input.events.empty() && input.shadows.empty()) || manifest.cutOuts) return passes;
    if (manifest.settings.mode == ViewMode::single && manifest.views.empty() && !manifest.fov)
        throw InputError(manifest.file.string() +
                         ": has neither view_frames nor fov, which say where single view ends");
    const Judge judge(input.geometry);
    auto shadows = input.shadows.begin();
    const auto judgeShadowsBefore = [&](int event) {
        for (; shadows != input.shadows.end() && shadows->event < event; ++shadows)
            passes.push_back(judgeVisibility(input, *shadows, judge, executor));
    };
    for (const DumpedHits& event : input.events) {
        judgeShadowsBefore(event.event);
        passes.push_back(judgeTrace(input, event, judge, executor));
    }
    judgeShadowsBefore(std::numeric_limits<int>::max());
    return passes;
}

std::string verdictText(const std::vector<JudgedPass>& passes) {
    if (const JudgedPass* wrong = firstWrong(passes))
        return wrong->name() + " is the first pass that is wrong: " + wrong->first;
    // Core's own traversal finds all hits in a structure that is right: this cannot be, or a judge
    // is at fault.
    const auto inherits = std::find_if(passes.begin(), passes.end(),
                                       [](const JudgedPass& pass) { return pass.inherited > 0; });
    if (inherits != passes.end())
        return inherits->name() + " is wrong as the structure is, in which no fault was found";
    return passes.empty() ? "nothing to judge" : "all is right";
}

bool isRight(const std::vector<JudgedPass>& passes) {
    return std::all_of(passes.begin(), passes.end(), [](const JudgedPass& pass) {
        return pass.wrong() == 0 && pass.inherited == 0;
    });
}

} // namespace dirt
