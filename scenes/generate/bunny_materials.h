#pragma once

#include <vector>

#include "scenes/generate/model.h"

namespace dirt::generate {

namespace bunny {

/// The bunny room's materials, in the order of their table.
enum Material : int {
    Stoneware,
    Eye,
    FloorBoard,
    Wallpaper,
    WhiteWood,
    Curtain,
    RugPile,
    RugFringe,
    Chair,
    Cushion,
    DarkWood,
    LampFoot,
    LampShade,
    Bulb,
    Brass,
    RedBook,
    BlueBook,
    GreenBook,
    OchreBook,
    Paper,
    ToyRed,
    ToyBlue,
    ToyYellow,
    ToyGreen,
    Carrot,
    CarrotTop,
    Plate,
    Gilt,
    Picture,
    Mount,
    PotClay,
    PotSoil,
    PlantLeaf
};

} // namespace bunny

std::vector<MaterialRecipe> bunnyMaterials();

} // namespace dirt::generate
