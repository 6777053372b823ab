#pragma once

namespace dirt::generate {

/// The atrium's materials, in the order of their table in atrium_materials.cpp.
enum AtriumMaterial : int {
    Limestone,
    Ashlar,
    WhiteMarble,
    RedMarble,
    GreenMarble,
    Plaster,
    Brick,
    Terracotta,
    RoofTile,
    Wood,
    RedCloth,
    BlueCloth,
    OchreCloth,
    GreenCloth,
    GoldTrim,
    Leaf,
    Ivy,
    Bark,
    Soil,
    Lemon,
    Water,
    Bronze,
    Grout,
    atriumMaterialCount
};

} // namespace dirt::generate
