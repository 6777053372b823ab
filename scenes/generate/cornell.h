#pragma once

#include "scenes/generate/model.h"

namespace dirt::generate {

/// The Cornell box, two units wide: 36 triangles at least, its faces subdivided to the detail.
Model makeCornell(const Detail& detail);

} // namespace dirt::generate
