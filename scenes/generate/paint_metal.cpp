#include <cmath>

#include <glm/common.hpp>

#include "scenes/generate/noise.h"
#include "scenes/generate/numbers.h"
#include "scenes/generate/paint.h"

namespace dirt::generate {
namespace {

/// Distance from x to the nearest multiple of `period`.
double toNearest(double x, double period) {
    return std::abs(x - period * std::round(x / period));
}

} // namespace

TextureRecipe paintedSteel(Colour paint, double wear, std::uint32_t seed) {
    return {512, [=](Vec2 p) {
                const double broad = fractalNoise(p, 3, 5, seed, 0.55);
                const double streaks = periodicNoise({p.x * 24, p.y * 2}, 24, seed + 1) +
                                       0.5 * periodicNoise({p.x * 64, p.y * 4}, 64, seed + 2);
                Colour colour = paint * (1 + 0.06 * broad + 0.03 * streaks);
                colour *= 1 - 0.22 * wear * smoothStep(0.2, 1.1, streaks + 0.6 * broad);
                const double chips = fractalNoise(p, 10, 5, seed + 3, 0.65) + 0.35 * broad;
                const double edge = 1.05 - 0.55 * wear;
                colour =
                    glm::mix(colour, rgb(0x8D8478), 0.8 * smoothStep(edge, edge + 0.05, chips));
                const Colour rust =
                    glm::mix(rgb(0x6B3A1E), rgb(0x94582C), 0.5 + fractalNoise(p, 32, 3, seed + 4));
                return glm::mix(colour, rust, smoothStep(edge + 0.06, edge + 0.12, chips));
            }};
}

TextureRecipe aluminiumSkin(Colour metal, int sheets, bool rivets, std::uint32_t seed) {
    return {1024, [=](Vec2 p) {
                const double x = p.x * sheets;
                const double y = p.y * sheets;
                const auto sheet = hashBits(static_cast<std::uint32_t>(x) % 64,
                                            static_cast<std::uint32_t>(y) % 64, seed);
                // Each sheet was rolled in its own direction, and polished by its own hand.
                const bool along = (sheet & 1) != 0;
                const double rolled = periodicNoise(
                    {along ? p.x * 8 : p.x * 160, along ? p.y * 160 : p.y * 8}, 160, seed + 1);
                const double clouds = fractalNoise(p, 4, 4, seed + 2);
                Colour colour = metal * hashRange(0.90, 1.03, sheet, 1);
                colour *= 1 + 0.025 * rolled + 0.05 * clouds;
                colour = glm::mix(colour, colour * rgb(0xE9F0F6), hashUnit(sheet, 2));
                const double seamX = toNearest(x, 1) / sheets;
                const double seamY = toNearest(y, 1) / sheets;
                const double seam = std::min(seamX, seamY);
                colour *= 1 - 0.45 * (1 - smoothStep(0.0005, 0.0014, seam));
                colour *= 1 - 0.08 * (1 - smoothStep(0.001, 0.010, seam));
                if (rivets) {
                    const double pitch = 1.0 / 72;
                    const double row = 0.0052;
                    const auto rivet = [&](double across, double way) {
                        return std::hypot(std::abs(across - row), toNearest(way, pitch));
                    };
                    const double d = std::min(rivet(seamX, p.y), rivet(seamY, p.x));
                    colour *= 1 - 0.28 * (1 - smoothStep(0.0012, 0.0024, d));
                }
                const double grime = smoothStep(0.25, 0.9, fractalNoise(p, 6, 5, seed + 5, 0.6));
                return colour * (1 - 0.12 * grime);
            }};
}

TextureRecipe concreteFloor() {
    return {
        1024, [](Vec2 p) {
            const double clouds = fractalNoise(p, 3, 6, 901, 0.55);
            const double fine = fractalNoise(p, 90, 3, 902);
            Colour colour = glm::mix(rgb(0x8E8A82), rgb(0xA8A298), smoothStep(-0.6, 0.6, clouds));
            colour *= 1 + 0.045 * fine;
            // The float leaves broad arcs.
            const double arcs = periodicNoise({p.x * 14 + 2 * clouds, p.y * 5}, 70, 903);
            colour *= 1 + 0.03 * arcs;
            const double oil = fractalNoise(p, 5, 5, 904, 0.55);
            colour = glm::mix(colour, rgb(0x3B3732), 0.65 * smoothStep(0.42, 0.85, oil));
            colour = glm::mix(colour, rgb(0x5C554B), 0.35 * smoothStep(0.22, 0.42, oil));
            const double drops = fractalNoise(p, 36, 2, 905);
            colour *= 1 - 0.35 * smoothStep(0.62, 0.75, drops);
            // Tyres have drawn dark, soft lines.
            for (int k = 0; k < 3; ++k) {
                const double line = 0.17 + 0.31 * k + 0.03 * periodicNoise({p.y * 2, 0.5}, 2, 906);
                const double t = toNearest(p.x - line, 1) / 0.012;
                colour *= 1 - 0.14 * std::exp(-t * t) * (0.6 + 0.4 * fractalNoise(p, 12, 2, 907));
            }
            const double crack = std::abs(fractalNoise(p, 2, 6, 908));
            const double gate = smoothStep(0.1, 0.4, fractalNoise(p, 2, 2, 909));
            colour *= 1 - 0.45 * gate * (1 - smoothStep(0.0, 0.006, crack));
            const double joint = std::min(toNearest(p.x, 0.5), toNearest(p.y, 0.5));
            colour *= 1 - 0.62 * (1 - smoothStep(0.0006, 0.0012, joint));
            return colour * (1 - 0.10 * (1 - smoothStep(0.001, 0.012, joint)));
        }};
}

TextureRecipe concreteRelief() {
    return {512, [](Vec2 p) {
                const double joint = std::min(toNearest(p.x, 0.5), toNearest(p.y, 0.5));
                const double height = 0.6 + 0.10 * fractalNoise(p, 24, 4, 911) -
                                      0.5 * (1 - smoothStep(0.0008, 0.002, joint));
                return Colour(height);
            }};
}

TextureRecipe hazardStripes(Colour bright, Colour dark) {
    return {512, [=](Vec2 p) {
                const double phase = 2 * (p.x + p.y) - std::floor(2 * (p.x + p.y));
                const double stripe =
                    smoothStep(0.0, 0.01, phase) * (1 - smoothStep(0.5, 0.51, phase));
                Colour colour = glm::mix(dark, bright, stripe);
                const double worn = fractalNoise(p, 6, 6, 921, 0.65);
                colour = glm::mix(colour, rgb(0x7A746A), 0.8 * smoothStep(0.45, 0.6, worn));
                return colour * (1 + 0.08 * fractalNoise(p, 3, 4, 922));
            }};
}

TextureRecipe floorPaint(Colour paint, std::uint32_t seed) {
    return {512, [=](Vec2 p) {
                const double worn = fractalNoise(p, 8, 6, seed, 0.7);
                Colour colour = paint * (1 + 0.07 * fractalNoise(p, 4, 4, seed + 1));
                colour = glm::mix(colour, rgb(0x827C72), 0.85 * smoothStep(0.25, 0.55, worn));
                return colour * (1 - 0.25 * smoothStep(0.3, 0.8, fractalNoise(p, 3, 4, seed + 2)));
            }};
}

TextureRecipe printedLabel(Colour ground, Colour print, Colour bar, std::uint32_t seed) {
    return {256, [=](Vec2 p) {
                Colour colour = ground * (1 + 0.03 * fractalNoise(p, 4, 4, seed));
                if (p.y > 0.78 && p.y < 0.93 && p.x > 0.08 && p.x < 0.92) return bar;
                const int line = static_cast<int>(p.y * 16);
                const int word = static_cast<int>(p.x * 22);
                const auto id = hashBits(static_cast<std::uint32_t>(line),
                                         static_cast<std::uint32_t>(word), seed);
                const double y = p.y * 16 - line;
                const bool inside = line >= 1 && line <= 11 && p.x > 0.1 && p.x < 0.9;
                if (inside && y > 0.3 && y < 0.72 && hashUnit(id, 1) < 0.78) colour = print;
                return colour;
            }};
}

} // namespace dirt::generate
