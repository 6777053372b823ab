#pragma once

#include "core/base/executor.h"
#include "core/grid/geometry.h"

namespace dirt {

/// makeFrameGeometry spread over an Executor: the same bits, for any number of threads, and the
/// same errors. Keeps the memory of \p geometry.
void transformMesh(const Mesh& mesh, const Camera& camera, ViewMode mode, Executor& executor,
                   FrameGeometry& geometry);

} // namespace dirt
