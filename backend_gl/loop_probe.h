#pragma once

#include "backend_gl/programs.h"

namespace dirt {

/// Whether the driver leaves the loops of a shader before they are through, as llvmpipe (Mesa 22.3)
/// does, without a word, once they have gone round 65535 times in all: looks at one of a million.
bool leavesLoops(Programs& programs);

} // namespace dirt
