#pragma once

#include "core/base/executor.h"
#include "core/scene/scene.h"

namespace dirt {

/// Brings what moves in \p scene, mesh and camera, to \p frame; from whichever frame it was at, the
/// result is the same bits. A vertex takes its float32 position in the moving space through the
/// space's matrix, computed in double and rounded to float32 once, by × and + in a fixed order
/// (G7); normals go through theirs in double. Allocates nothing. Throws InputError where a vertex
/// leaves float32.
void moveScene(Scene& scene, int frame, Executor& executor);

} // namespace dirt
