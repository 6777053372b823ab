#pragma once

#include "backend_gl/programs.h"

namespace dirt {

/// Whether what \p proposal draws, as the driver rasterizes now, reaches every tile that the
/// rectangles reach and the exact test takes: over a few thousand triangles that are hard to
/// rasterize.
bool proposesAllTiles(Programs& programs, Proposal proposal);

} // namespace dirt
