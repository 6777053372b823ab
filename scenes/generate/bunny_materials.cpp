#include "scenes/generate/bunny_materials.h"

#include "scenes/generate/paint.h"

namespace dirt::generate {

std::vector<MaterialRecipe> bunnyMaterials() {
    const auto satin = [](std::string name, double gloss, double repeat, TextureRecipe texture) {
        return MaterialRecipe{.name = std::move(name),
                              .reflectivity = 0.04,
                              .gloss = gloss,
                              .repeat = repeat,
                              .texture = std::move(texture)};
    };
    const auto cloth = [](std::string name, double repeat, TextureRecipe texture) {
        return MaterialRecipe{
            .name = std::move(name), .repeat = repeat, .texture = std::move(texture)};
    };
    const auto paint = [](std::string name, unsigned hex, double gloss = 105) {
        const Colour c = rgb(hex);
        return MaterialRecipe{
            .name = std::move(name), .diffuse = c * c, .reflectivity = 0.04, .gloss = gloss};
    };
    return {
        satin("stoneware", 116, 0.25, speckledGlaze(rgb(0xE9E1D0), rgb(0x7A5B40))),
        paint("eye", 0x241A14, 126),
        satin("floor_board", 92, 0.9, timber(rgb(0xB98A58), rgb(0x8A5F36))),
        satin("wallpaper", 20, 0.62, damask(rgb(0xBAC2AC), rgb(0xC8CFBB), 2001)),
        satin("white_wood", 80, 2, plaster(rgb(0xEDE8DC), rgb(0xE2DBCB))),
        cloth("curtain", 0.4, damask(rgb(0xE6D9BC), rgb(0xDCCBA6), 2011)),
        cloth("rug_pile", 1, carpet()),
        cloth("rug_fringe", 0.2, damask(rgb(0xDCCFAF), rgb(0xD2C29C), 2021)),
        cloth("chair", 0.5, damask(rgb(0x5F7882), rgb(0x6B858E), 2031)),
        cloth("cushion", 0.3, damask(rgb(0xBF8A50), rgb(0xCB9A62), 2041)),
        satin("dark_wood", 100, 0.6, timber(rgb(0x6E4426), rgb(0x3A2112))),
        satin("lamp_foot", 118, 0.5, speckledGlaze(rgb(0x2F5F78), rgb(0x16303F))),
        {.name = "lamp_shade", .diffuse = {0.80, 0.72, 0.58}, .emission = {1.35, 0.92, 0.50}},
        {.name = "bulb", .diffuse = glm::dvec3(0.8), .emission = {3, 2.1, 1.2}},
        {.name = "brass",
         .diffuse = {0.62, 0.44, 0.18},
         .reflectivity = 0.9,
         .gloss = 104,
         .metallic = 1},
        satin("red_book", 60, 0.3, damask(rgb(0x8E2A22), rgb(0x96332A), 2051)),
        satin("blue_book", 60, 0.3, damask(rgb(0x274A6E), rgb(0x2F547A), 2061)),
        satin("green_book", 60, 0.3, damask(rgb(0x3C5B3A), rgb(0x456642), 2071)),
        satin("ochre_book", 60, 0.3, damask(rgb(0xB98A3A), rgb(0xC29548), 2081)),
        satin("paper", 10, 0.05, pages()),
        paint("toy_red", 0xC8322A),
        paint("toy_blue", 0x2F6DB0),
        paint("toy_yellow", 0xE3B23C),
        paint("toy_green", 0x4E9A58),
        satin("carrot", 70, 0.12, clay(rgb(0xE0782A), 2091)),
        paint("carrot_top", 0x5E8F3A, 40),
        satin("plate", 122, 0.3, speckledGlaze(rgb(0xF0EDE4), rgb(0xC8C0B0))),
        satin("gilt", 90, 0.3, braid()),
        satin("picture", 90, 1, landscape()),
        satin("mount", 10, 0.5, plaster(rgb(0xEDE6D6), rgb(0xE8E0CE))),
        satin("pot_clay", 20, 0.8, clay(rgb(0xB8683F), 2101)),
        satin("pot_soil", 5, 0.4, clay(rgb(0x4A3626), 2111)),
        satin("plant_leaf", 95, 1, foliage(rgb(0x2F6B34), rgb(0x7FA860))),
    };
}

} // namespace dirt::generate
