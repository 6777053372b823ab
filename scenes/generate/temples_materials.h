#pragma once

#include <vector>

#include "scenes/generate/model.h"

namespace dirt::generate {

namespace temples {

constexpr int ridgeCount = 4;
constexpr int seaBands = 8;

/// The temples' materials, in the order of their table. Haze is emission.
enum Material : int {
    Ground,
    Rock,
    Marble,
    Grass,
    OliveLeaf,
    OliveBark,
    Shrub,
    Cypress,
    Ridge,
    Sea = Ridge + ridgeCount,
    Sky = Sea + seaBands,
    materialCount
};

} // namespace temples

std::vector<MaterialRecipe> templesMaterials();

} // namespace dirt::generate
