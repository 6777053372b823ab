#include "scenes/generate/temples_materials.h"

#include <cmath>

#include "scenes/generate/paint.h"
#include "scenes/generate/temples_sky.h"

namespace dirt::generate {

std::vector<MaterialRecipe> templesMaterials() {
    using namespace temples;
    const auto matt = [](std::string name, double repeat, TextureRecipe texture) {
        return MaterialRecipe{.name = std::move(name),
                              .reflectivity = 0.02,
                              .gloss = 15,
                              .repeat = repeat,
                              .texture = std::move(texture)};
    };
    MaterialRecipe marble = matt("marble", 3.5, weatheredMarble());
    marble.bump = weatheredRelief();
    std::vector<MaterialRecipe> all = {
        matt("ground", 9, dryGround()),
        matt("rock", 1.7, limestoneRock()),
        marble,
        {.name = "grass", .diffuse = {0.58, 0.50, 0.27}, .reflectivity = 0.02, .gloss = 20},
        matt("olive_leaf", 1, foliage(rgb(0x7E8B5A), rgb(0xB4BC98))),
        matt("olive_bark", 0.4, timber(rgb(0x8A7B68), rgb(0x4C4236))),
        matt("shrub", 1, foliage(rgb(0x5C6B34), rgb(0x8E9A5C))),
        matt("cypress", 1, foliage(rgb(0x35502C), rgb(0x4E6A3C))),
    };
    const glm::dvec3 haze = skyRadiance(0.5);
    const auto hazy = [&](std::string name, glm::dvec3 colour, double share, double gloss) {
        return MaterialRecipe{.name = std::move(name),
                              .diffuse = colour * (1 - share),
                              .reflectivity = gloss > 0 ? 0.02 * (1 - share) : 0,
                              .gloss = gloss,
                              .emission = haze * glm::dvec3(0.62, 0.74, 0.92) * share};
    };
    for (int k = 0; k < ridgeCount; ++k) {
        const double share = 0.22 + 0.56 * k / (ridgeCount - 1);
        all.push_back(hazy("ridge_" + std::to_string(k), {0.34, 0.31, 0.22}, share, 0));
    }
    for (int k = 0; k < seaBands; ++k) {
        const double share = 0.10 + 0.65 * std::pow(k / (seaBands - 1.0), 1.3);
        all.push_back(hazy("sea_" + std::to_string(k), {0.05, 0.16, 0.22}, share, 112));
    }
    all.push_back(skyMaterial());
    return all;
}

} // namespace dirt::generate
