#pragma once

#include "scenes/generate/model.h"

namespace dirt::generate {

/// An Italian court: two storeys of arcades, banners, a fountain, lemon trees, open sky.
Model makeAtrium(const Detail& detail);

/// The materials of the atrium, in the order of AtriumMaterial.
std::vector<MaterialRecipe> atriumMaterials();

} // namespace dirt::generate
