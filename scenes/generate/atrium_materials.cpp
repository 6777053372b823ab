#include "scenes/generate/atrium_materials.h"

#include "scenes/generate/atrium.h"
#include "scenes/generate/paint.h"

namespace dirt::generate {

std::vector<MaterialRecipe> atriumMaterials() {
    const auto stone = [](std::string name, double gloss, double repeat, TextureRecipe texture) {
        return MaterialRecipe{.name = std::move(name),
                              .reflectivity = 0.04,
                              .gloss = gloss,
                              .repeat = repeat,
                              .texture = std::move(texture)};
    };
    const auto plain = [](std::string name, double repeat, TextureRecipe texture) {
        return MaterialRecipe{.name = std::move(name),
                              .reflectivity = 0.02,
                              .gloss = 20,
                              .repeat = repeat,
                              .texture = std::move(texture)};
    };
    return {
        stone("limestone", 30, 2.0, limestone(0)),
        stone("ashlar", 30, 2.4, limestone(6)),
        stone("white_marble", 100, 1.6,
              marble(rgb(0xEFEAE0), rgb(0xD8D3CA), rgb(0x8E8A88), 3, 101)),
        stone("red_marble", 100, 1.6, marble(rgb(0xAE6A56), rgb(0x84483A), rgb(0xE6CDB8), 4, 201)),
        stone("green_marble", 100, 1.6,
              marble(rgb(0x3F5F4C), rgb(0x24392F), rgb(0xA9BFAE), 4, 301)),
        plain("plaster", 3.2, plaster(rgb(0xE2BE8A), rgb(0xE6D8BC))),
        plain("brick", 1.12, bricks()),
        plain("terracotta", 0.8, clay(rgb(0xB8683F), 401)),
        plain("roof_tile", 0.9, clay(rgb(0xA9603F), 411)),
        plain("wood", 0.9, timber(rgb(0x8A5E38), rgb(0x4E3119))),
        plain("red_cloth", 0.55, damask(rgb(0x96181C), rgb(0xB8322A), 501)),
        plain("blue_cloth", 0.55, damask(rgb(0x1E3A78), rgb(0x3A62A4), 511)),
        plain("ochre_cloth", 0.55, damask(rgb(0xC99A45), rgb(0xDDBA70), 521)),
        plain("green_cloth", 0.55, damask(rgb(0x1F5A3C), rgb(0x3B8058), 531)),
        stone("gold_trim", 60, 0.12, braid()),
        stone("leaf", 50, 1.0, foliage(rgb(0x4E7A2E), rgb(0x93AE5C))),
        stone("ivy", 40, 1.0, foliage(rgb(0x3F6B2B), rgb(0x9DB374))),
        plain("bark", 0.3, timber(rgb(0x7A6248), rgb(0x4A3A2A))),
        plain("soil", 0.4, clay(rgb(0x4A3626), 431)),
        {.name = "lemon", .diffuse = {0.80, 0.58, 0.06}, .reflectivity = 0.04, .gloss = 70},
        {.name = "water", .diffuse = {0.06, 0.15, 0.16}, .reflectivity = 0.02, .gloss = 127},
        {.name = "bronze",
         .diffuse = {0.42, 0.30, 0.14},
         .reflectivity = 0.9,
         .gloss = 90,
         .metallic = 1},
        {.name = "grout", .diffuse = {0.30, 0.26, 0.21}},
    };
}

} // namespace dirt::generate
