#pragma once

#include "core/frame/renderer.h"

namespace dirt {

/// Warns where radiance has left float's range and was clamped (kMostRadiance), unless \p quiet.
void noteClamped(const RenderResult& result, bool quiet);

} // namespace dirt
