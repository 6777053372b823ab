#pragma once

#include "scenes/generate/model.h"

namespace dirt::generate {

/// Ruined Doric temples on a rocky cape, with islands in the haze.
Model makeTemples(const Detail& detail);

} // namespace dirt::generate
