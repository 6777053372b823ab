#include "scenes/generate/temples_materials.h"

#include <cmath>

#include <glm/common.hpp>

#include "scenes/generate/loft.h"
#include "scenes/generate/paint.h"

namespace dirt::generate {

namespace temples {

double skyElevation(int band) {
    // Fine where pictures look, coarse towards the zenith.
    const double s = static_cast<double>(band) / skyBands;
    return -3 + 33 * s + 60 * std::pow(s, 4.0);
}

} // namespace temples

namespace {

using namespace temples;

/// Radiance of the sky at an elevation in degrees.
glm::dvec3 skyRadiance(double elevation) {
    static const Keys red{{-3, 1.55}, {0, 1.50}, {5, 1.22}, {12, 0.86}, {30, 0.50}, {90, 0.30}};
    static const Keys green{{-3, 1.38}, {0, 1.38}, {5, 1.30}, {12, 1.10}, {30, 0.80}, {90, 0.52}};
    static const Keys blue{{-3, 1.20}, {0, 1.24}, {5, 1.38}, {12, 1.46}, {30, 1.36}, {90, 1.05}};
    return {red(elevation), green(elevation), blue(elevation)};
}

} // namespace

std::vector<MaterialRecipe> templesMaterials() {
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
    for (int k = 0; k < skyBands; ++k) {
        const double elevation = 0.5 * (skyElevation(k) + skyElevation(k + 1));
        all.push_back({.name = "sky_" + std::to_string(k),
                       .diffuse = glm::dvec3(0),
                       .emission = skyRadiance(elevation)});
    }
    return all;
}

} // namespace dirt::generate
