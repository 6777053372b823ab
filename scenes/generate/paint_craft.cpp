#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "scenes/generate/noise.h"
#include "scenes/generate/numbers.h"
#include "scenes/generate/paint.h"

namespace dirt::generate {
namespace {

/// One damask figure around the origin: a palmette of petals over a stem, positive inside.
double palmette(Vec2 p) {
    p.x = std::abs(p.x);
    const double radius = glm::length(p);
    const double angle = std::atan2(p.x, p.y); // 0 is up
    double inside = 0.30 + 0.075 * std::cos(7 * angle) * smoothStep(2.6, 1.9, angle) - radius;
    inside = std::max(inside, -1.0);
    const double core = 0.085 - glm::length(p - Vec2(0, 0.05));
    const double ring = std::abs(core + 0.035) - 0.014;
    const double petals = std::abs(std::sin(3.5 * angle)) * radius - 0.022;
    double figure = std::min(inside, std::max(petals, core));
    figure = std::min(figure, std::max(ring, core - 0.02));
    // An ogee frame that joins its neighbours.
    const double frame = std::abs(radius - 0.40 - 0.05 * std::cos(4 * angle)) - 0.018;
    return std::max(figure, -frame);
}

} // namespace

TextureRecipe clay(Colour base, std::uint32_t seed) {
    return {512, [=](Vec2 p) {
                const double bands = fractalNoise(Vec2(0.37, p.y), 12, 3, seed);
                const double bloom = fractalNoise(p, 4, 6, seed + 1, 0.6);
                Colour colour = base * (1 + 0.07 * bands + 0.05 * fractalNoise(p, 48, 3, seed + 2));
                colour = glm::mix(colour, rgb(0xD9C3A8), 0.5 * smoothStep(0.25, 0.9, bloom));
                return glm::mix(colour, base * 0.55, 0.5 * smoothStep(0.3, 0.9, -bloom));
            }};
}

TextureRecipe timber(Colour light, Colour dark) {
    return {512, [=](Vec2 p) {
                const double bend = 0.02 * fractalNoise(p, 2, 3, 51);
                // Grain is noise squeezed across the plank: many cells in x, few in y.
                double grain = 0;
                double weight = 1;
                for (std::uint32_t octave = 0; octave < 4; ++octave) {
                    const int cells = 16 << octave;
                    grain +=
                        weight *
                        periodicNoise({(p.x + bend) * cells, p.y * 4 + 0.0}, cells, 52 + octave) *
                        (0.8 + 0.2 * std::cos(turn * p.y));
                    weight *= 0.6;
                }
                // The coarse axis must repeat too: blend the lattice's two ends.
                const double rings = std::sin(turn * (6 * p.x + 0.8 * fractalNoise(p, 2, 2, 57)));
                Colour colour =
                    glm::mix(light, dark, smoothStep(-0.9, 0.9, 0.8 * grain + 0.35 * rings));
                return colour * (1 + 0.06 * fractalNoise(p, 64, 2, 58));
            }};
}

TextureRecipe damask(Colour ground, Colour figure, std::uint32_t seed) {
    return {512, [=](Vec2 p) {
                // Two figures in a half-drop repeat.
                const auto centred = [](double x) { return x - std::floor(x) - 0.5; };
                const double a = palmette({centred(p.x), centred(p.y) * 1.0});
                const double b = palmette({centred(p.x + 0.5), centred(p.y + 0.5)});
                const double shape = smoothStep(-0.004, 0.006, std::max(a, b));
                Colour colour = glm::mix(ground, figure, shape);
                const double weave = std::sin(turn * 128 * p.x) * std::sin(turn * 128 * p.y);
                const double thread = periodicNoise({p.x * 128, p.y * 16}, 128, seed) +
                                      periodicNoise({p.x * 16, p.y * 128}, 128, seed + 1);
                const double worn = fractalNoise(p, 3, 4, seed + 2);
                return colour * (1 + 0.04 * weave + 0.05 * thread + 0.06 * worn);
            }};
}

TextureRecipe braid() {
    return {256, [](Vec2 p) {
                const double twist =
                    std::sin(turn * (16 * p.y + 8 * std::abs(std::sin(turn * 2 * p.x)) / 8));
                const double rope = std::sin(turn * (24 * p.x)) * 0.5 + 0.5 * twist;
                const Colour colour =
                    glm::mix(rgb(0x94702F), rgb(0xE4C684), smoothStep(-1, 1, rope));
                return colour * (1 + 0.06 * fractalNoise(p, 32, 2, 61));
            }};
}

TextureRecipe foliage(Colour green, Colour pale) {
    return {256, [=](Vec2 p) {
                const double across = std::abs(2 * p.x - 1);
                const double rib = 1 - smoothStep(0.03, 0.09, across);
                const double side = std::abs(std::sin(std::numbers::pi * (7 * p.y - 2.2 * across)));
                const double veins = (1 - smoothStep(0.0, 0.25, side)) * (1 - across) * 0.55;
                Colour colour = green * (1 + 0.20 * fractalNoise(p, 4, 4, 71));
                colour = glm::mix(colour, pale, std::max(0.75 * rib, veins));
                return glm::mix(colour, green * 1.3, 0.35 * smoothStep(0.7, 1.0, across));
            }};
}

} // namespace dirt::generate
