#pragma once

#include "core/base/executor.h"
#include "core/replay/judged_pass.h"
#include "core/replay/replay_input.h"
#include "core/verify/judge.h"

namespace dirt {

/// Trace of one path event: each hit against exact arithmetic over all triangles; t within
/// kFinality, barycentric weights within kWeightError; and the tile that lists the record has to
/// list the primitive. Where core's traversal of the dumped structure is wrong in the same way, the
/// fault is inherited from a pass before, and not counted in this one.
JudgedPass judgeTrace(const ReplayInput& input, const DumpedHits& event, const Judge& judge,
                      Executor& executor);

/// What a barycentric weight may be off (intersect.h).
inline constexpr double kWeightError = 0x1p-23;

} // namespace dirt
