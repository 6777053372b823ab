#pragma once

#include "core/check/check_row.h"
#include "core/frame/backend.h"
#include "core/replay/replay_input.h"

#include <vector>

namespace dirt {

/// Builds the structure of the dump's triangles and settings on \p backend, traces the dump's rays
/// through it, and compares what the dump has: depths may be off by kDepthUlps, lists by what that
/// makes of bins, hits by what may differ where arithmetic is not IEEE (compare_paths.h). What
/// differs need not be wrong: that the judges say. Throws InputError where the dump's views are not
/// those of makeViews, or the dump does not say what they are.
std::vector<CheckRow> replayAgainst(const ReplayInput& input, Backend& backend);

} // namespace dirt
