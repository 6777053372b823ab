#pragma once

#include "core/base/executor.h"
#include "core/replay/judged_pass.h"
#include "core/replay/replay_input.h"

namespace dirt {

// Judges of the passes of construction. What equals core's definition is right; what does not is
// decided in exact arithmetic, by what grid.md promises and no more, so that another engine may
// round, and place its guard band, in its own way. The input has a grid.

/// FillDepth: each tile's bounds contain the depths of all parts within kComplete of a tile (G1),
/// and exceed those within kTight by kDepthUlps at most (G2).
JudgedPass judgeFillDepth(const ReplayInput& input, Executor& executor);

/// FillDepthMipmap: each cell is the minimum and maximum of those below it, as dumped.
JudgedPass judgeFillDepthMipmap(const ReplayInput& input);

/// FillPrimitives: the lists in any order, with each entry once, over the bounds as dumped. A bin
/// whose border is within rounding of an interval's end may have the primitive or not.
JudgedPass judgeFillPrimitives(const ReplayInput& input, Executor& executor);

/// The triangles at the eye, where the dump says them.
JudgedPass judgeAtEye(const ReplayInput& input);

/// What a tile has to list, and what it may list, as parts of a tile beyond its borders (G1, G2).
inline constexpr double kComplete = 1.0 / 512.0, kTight = 1.0 / 64.0;

/// What a depth interval may exceed the exact one by, in units in the last place (G2).
inline constexpr int kDepthUlps = 16;

/// "view +X, column 3, row 5", of a place with a tile; and the bin, where it has one.
std::string cellText(const ReplayInput& input, const ReplayPlace& place);

} // namespace dirt
