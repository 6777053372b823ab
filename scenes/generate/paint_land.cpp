#include <cmath>

#include <glm/common.hpp>

#include "scenes/generate/noise.h"
#include "scenes/generate/numbers.h"
#include "scenes/generate/paint.h"

namespace dirt::generate {
namespace {

/// Pits and cracks of weathered stone, 0 in their depth to 1 on the surface.
double stoneHeight(Vec2 p) {
    const double pits = smoothStep(0.25, 0.7, fractalNoise(p, 22, 4, 1001, 0.6));
    const double crack = std::abs(fractalNoise(p, 4, 5, 1002));
    const double gate = smoothStep(0.0, 0.4, fractalNoise(p, 3, 2, 1003));
    return 1 - 0.7 * pits - 0.5 * gate * (1 - smoothStep(0.0, 0.02, crack));
}

} // namespace

TextureRecipe weatheredMarble() {
    return {1024, [](Vec2 p) {
                const double clouds = fractalNoise(p, 3, 5, 1011, 0.55);
                Colour colour =
                    glm::mix(rgb(0xE0D6C0), rgb(0xC6B697), smoothStep(-0.5, 0.6, clouds));
                // Patina: ochre where iron runs out, grey crusts, lichen in flecks.
                const double ochre = fractalNoise(p, 5, 5, 1012, 0.6);
                colour = glm::mix(colour, rgb(0xCFB088), 0.32 * smoothStep(0.15, 0.8, ochre));
                const double grey = fractalNoise(p, 4, 6, 1013, 0.62);
                colour = glm::mix(colour, rgb(0x9A9384), 0.38 * smoothStep(0.22, 0.7, grey));
                const double lichen = fractalNoise(p, 14, 4, 1014, 0.6);
                colour = glm::mix(colour, rgb(0x55524A), 0.5 * smoothStep(0.55, 0.68, lichen));
                const double height = stoneHeight(p);
                return colour * (0.70 + 0.30 * height) * (1 + 0.05 * fractalNoise(p, 96, 2, 1015));
            }};
}

TextureRecipe weatheredRelief() {
    return {512, [](Vec2 p) { return Colour(0.9 * stoneHeight(p)); }};
}

TextureRecipe limestoneRock() {
    return {512, [](Vec2 p) {
                const double clouds = fractalNoise(p, 3, 6, 1021, 0.6);
                Colour colour =
                    glm::mix(rgb(0xB8AB93), rgb(0x857A67), smoothStep(-0.5, 0.6, clouds));
                const double rust = fractalNoise(p, 4, 4, 1022);
                colour = glm::mix(colour, rgb(0xA08566), 0.3 * smoothStep(0.2, 0.8, rust));
                const double lichen = fractalNoise(p, 12, 4, 1023, 0.6);
                colour = glm::mix(colour, rgb(0xCBC6B4), 0.5 * smoothStep(0.5, 0.7, lichen));
                colour = glm::mix(colour, rgb(0x4B463C), 0.5 * smoothStep(0.45, 0.8, -lichen));
                const double crack = std::abs(fractalNoise(p, 5, 5, 1024));
                return colour * (1 - 0.4 * (1 - smoothStep(0.0, 0.03, crack))) *
                       (1 + 0.08 * fractalNoise(p, 64, 3, 1025));
            }};
}

TextureRecipe dryGround() {
    return {1024, [](Vec2 p) {
                const double broad = fractalNoise(p, 3, 6, 1031, 0.6);
                Colour colour =
                    glm::mix(rgb(0xA3947A), rgb(0x857761), smoothStep(-0.4, 0.5, broad));
                const double straw = fractalNoise(p, 6, 5, 1032, 0.65);
                colour = glm::mix(colour, rgb(0xB5A873), 0.6 * smoothStep(0.05, 0.6, straw));
                const double green = fractalNoise(p, 5, 5, 1033, 0.65);
                colour = glm::mix(colour, rgb(0x6C7148), 0.6 * smoothStep(0.25, 0.75, green));
                // Gravel: the cells of a fine noise, each stone with its own shade.
                const double stones = fractalNoise(p, 110, 2, 1034);
                const double gravel = smoothStep(-0.1, 0.4, fractalNoise(p, 4, 4, 1035));
                colour =
                    glm::mix(colour, rgb(0xC9BDA2), 0.75 * gravel * smoothStep(0.35, 0.6, stones));
                colour *= 1 - 0.35 * gravel * smoothStep(0.2, 0.6, -stones);
                return colour * (1 + 0.12 * fractalNoise(p, 48, 4, 1036, 0.65));
            }};
}

} // namespace dirt::generate
