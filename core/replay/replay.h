#pragma once

#include "core/base/executor.h"
#include "core/replay/judged_pass.h"
#include "core/replay/replay_input.h"

#include <vector>

namespace dirt {

/// Judges every buffer of a dump that has a judge, in the order of the passes that wrote them.
std::vector<JudgedPass> judgeDump(const ReplayInput& input, Executor& executor);

/// The answer in one sentence.
std::string verdictText(const std::vector<JudgedPass>& passes);

/// Whether nothing is wrong.
bool isRight(const std::vector<JudgedPass>& passes);

} // namespace dirt
