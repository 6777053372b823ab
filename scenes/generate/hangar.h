#pragma once

#include "scenes/generate/model.h"

namespace dirt::generate {

/// A hall of steel lit by panels, with an airliner of the 1930s and what its mechanics need.
Model makeHangar(const Detail& detail);

} // namespace dirt::generate
