#pragma once

#include <vector>

#include "scenes/generate/model.h"

namespace dirt::generate {

namespace temples {

constexpr int ridgeCount = 4;
constexpr int seaBands = 8;
constexpr int skyBands = 48;

/// The temples' materials, in the order of their table. Haze and sky are bands of plain emission.
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
    materialCount = Sky + skyBands
};

/// Where a band of the sky ends, as an elevation in degrees.
double skyElevation(int band);

} // namespace temples

std::vector<MaterialRecipe> templesMaterials();

} // namespace dirt::generate
