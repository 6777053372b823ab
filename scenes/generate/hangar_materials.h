#pragma once

#include <vector>

#include "scenes/generate/model.h"

namespace dirt::generate {

namespace hangar {

/// The hangar's materials, in the order of their table.
enum Material : int {
    Floor,
    Wall,
    WallPaint,
    Roof,
    Steel,
    Concrete,
    LightPanel,
    LightHousing,
    Daylight,
    CraneYellow,
    Cable,
    Aluminium,
    Polished,
    WhitePaint,
    RedPaint,
    Glass,
    Rubber,
    Iron,
    Propeller,
    BladeTip,
    Brass,
    ToolRed,
    DrumBlue,
    DrumRust,
    Plank,
    Hazard,
    YellowLine,
    WhiteLine,
    Label,
    GreenSteel,
    Hose,
    Fabric
};

} // namespace hangar

std::vector<MaterialRecipe> hangarMaterials();

} // namespace dirt::generate
