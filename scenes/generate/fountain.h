#pragma once

#include "scenes/generate/mesh.h"

namespace dirt::generate {

/// An octagonal basin on steps, about 2.4 m in radius, with two bowls above one another.
Mesh makeFountain(const Detail& detail);

} // namespace dirt::generate
