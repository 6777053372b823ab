#pragma once

#include "core/base/executor.h"
#include "core/replay/judged_pass.h"
#include "core/replay/replay_input.h"
#include "core/verify/judge.h"

namespace dirt {

/// Visibility of one path event: each answer against exact arithmetic over all triangles. Where the
/// only ones in between are hit within kFinality of a ray's end, either answer is right, as t is
/// compared with the end when it has been rounded. A named blocker is one of those in between, any
/// of them, and the tile in which it is filed lists it. Where core's traversal of the dumped
/// structure is wrong in the same way, the fault is inherited from a pass before.
JudgedPass judgeVisibility(const ReplayInput& input, const DumpedShadows& shadows,
                           const Judge& judge, Executor& executor);

} // namespace dirt
