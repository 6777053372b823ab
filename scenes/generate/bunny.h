#pragma once

#include "scenes/generate/model.h"

namespace dirt::generate {

/// A rabbit of stoneware in the furnished corner of a room.
Model makeBunny(const Detail& detail);

} // namespace dirt::generate
