#include "scenes/generate/hangar_materials.h"

#include "scenes/generate/paint.h"

namespace dirt::generate {

std::vector<MaterialRecipe> hangarMaterials() {
    const auto coated = [](std::string name, double gloss, double repeat, TextureRecipe texture) {
        return MaterialRecipe{.name = std::move(name),
                              .reflectivity = 0.04,
                              .gloss = gloss,
                              .repeat = repeat,
                              .texture = std::move(texture)};
    };
    const auto metal = [](std::string name, double gloss, glm::dvec3 colour, double repeat = 1,
                          TextureRecipe texture = {}) {
        return MaterialRecipe{.name = std::move(name),
                              .diffuse = colour,
                              .reflectivity = 0.9,
                              .gloss = gloss,
                              .metallic = 0.9,
                              .repeat = repeat,
                              .texture = std::move(texture)};
    };
    const auto lamp = [](std::string name, glm::dvec3 emission) {
        return MaterialRecipe{
            .name = std::move(name), .diffuse = glm::dvec3(0.7), .emission = emission};
    };
    MaterialRecipe floor = coated("floor", 88, 10, concreteFloor());
    floor.bump = concreteRelief();
    return {
        floor,
        coated("wall", 40, 3, paintedSteel(rgb(0xA9B2AC), 0.65, 11)),
        coated("wall_paint", 50, 3, paintedSteel(rgb(0x55796E), 0.75, 21)),
        coated("roof", 40, 4, paintedSteel(rgb(0xBEC4C2), 0.45, 31)),
        coated("steel", 55, 2, paintedSteel(rgb(0x5B6B70), 0.6, 41)),
        coated("concrete", 20, 2.5, plaster(rgb(0xA7A298), rgb(0x8C867C))),
        lamp("light_panel", {2.9, 3.15, 3.3}),
        coated("light_housing", 60, 1, paintedSteel(rgb(0xC9CCC8), 0.2, 51)),
        lamp("daylight", {1.9, 2.5, 3.2}),
        coated("crane_yellow", 70, 2.5, paintedSteel(rgb(0xE0AE2A), 0.7, 61)),
        metal("cable", 60, {0.16, 0.15, 0.14}),
        metal("aluminium", 104, {1, 1, 1}, 2.6, aluminiumSkin(rgb(0xD3D6D9), 3, true, 71)),
        metal("polished", 118, {0.80, 0.81, 0.82}),
        coated("white_paint", 108, 2.6, aluminiumSkin(rgb(0xEFEBE0), 3, true, 81)),
        coated("red_paint", 110, 2.6, aluminiumSkin(rgb(0xA3201C), 3, false, 91)),
        {.name = "glass", .diffuse = {0.035, 0.05, 0.06}, .reflectivity = 0.08, .gloss = 124},
        {.name = "rubber", .diffuse = {0.035, 0.034, 0.033}, .reflectivity = 0.03, .gloss = 45},
        metal("iron", 84, {1, 1, 1}, 0.8, paintedSteel(rgb(0x6B6A68), 0.3, 101)),
        metal("propeller", 100, {0.10, 0.10, 0.105}),
        coated("blade_tip", 100, 1, paintedSteel(rgb(0xE0A51E), 0.2, 111)),
        metal("brass", 100, {0.60, 0.42, 0.17}),
        coated("tool_red", 105, 1.5, paintedSteel(rgb(0xB01F17), 0.5, 121)),
        coated("drum_blue", 90, 1.5, paintedSteel(rgb(0x1F4E86), 0.75, 131)),
        coated("drum_rust", 60, 1.5, paintedSteel(rgb(0x9A4B22), 0.9, 141)),
        coated("plank", 25, 0.9, timber(rgb(0xB08A5A), rgb(0x7A5732))),
        coated("hazard", 70, 0.8, hazardStripes(rgb(0xE2AE1D), rgb(0x1C1B19))),
        coated("yellow_line", 60, 2, floorPaint(rgb(0xD8A51E), 151)),
        coated("white_line", 60, 2, floorPaint(rgb(0xDAD8D0), 161)),
        coated("label", 60, 0.4, printedLabel(rgb(0xE8E4D6), rgb(0x2A2A2A), rgb(0xB3261E), 171)),
        coated("green_steel", 75, 2, paintedSteel(rgb(0x3D5A44), 0.6, 181)),
        {.name = "hose", .diffuse = {0.05, 0.05, 0.055}, .reflectivity = 0.03, .gloss = 60},
        coated("fabric", 10, 0.5, damask(rgb(0x5A6350), rgb(0x525B49), 191)),
    };
}

} // namespace dirt::generate
