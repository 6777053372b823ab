#include <cmath>

#include <glm/common.hpp>

#include "scenes/generate/noise.h"
#include "scenes/generate/numbers.h"
#include "scenes/generate/paint.h"

namespace dirt::generate {
namespace {

/// Which block of a coursed wall a point lies in, and how far from its joints.
struct Block {
    std::uint32_t id;
    double joint; ///< distance to the nearest joint, in texture units
};

Block findBlock(Vec2 unit, int courses, int perCourse, double shift) {
    const double y = unit.y * courses;
    const int row = static_cast<int>(std::floor(y)) % courses;
    const double x = unit.x * perCourse + shift * row + perCourse;
    const int column = static_cast<int>(std::floor(x)) % perCourse;
    const double dx = std::min(x - std::floor(x), 1 - (x - std::floor(x))) / perCourse;
    const double dy = std::min(y - std::floor(y), 1 - (y - std::floor(y))) / courses;
    return {hashBits(static_cast<std::uint32_t>(row), static_cast<std::uint32_t>(column), 5),
            std::min(dx, dy)};
}

} // namespace

TextureRecipe limestone(int courses) {
    return {1024, [courses](Vec2 p) {
                const double clouds = fractalNoise(p, 3, 6, 11);
                const double grain = fractalNoise(p, 96, 3, 12);
                const double beds = fractalNoise(p * Vec2(1, 1) + Vec2(0.04 * clouds), 6, 4, 13);
                Colour colour =
                    glm::mix(rgb(0xE3D5B8), rgb(0xC9B48E), smoothStep(-0.5, 0.7, clouds));
                colour = glm::mix(colour, rgb(0xD9BE94), 0.35 * smoothStep(0.0, 0.8, beds));
                colour *= 1 + 0.045 * grain;
                // Pits, as in travertine.
                const double pits = fractalNoise(Vec2(p.x, p.y), 40, 3, 14);
                colour *= 1 - 0.22 * smoothStep(0.48, 0.8, pits);
                const double stain =
                    fractalNoise(Vec2(p.x, 0.0) + Vec2(0, 0.15) * p.y * 0.0, 10, 4, 15) *
                    (0.5 + 0.5 * fractalNoise(p, 2, 3, 16));
                colour *= 1 - 0.10 * smoothStep(0.1, 0.7, stain);
                if (courses > 0) {
                    const Block block = findBlock(p, courses, courses / 2, 0.5);
                    colour *= hashRange(0.88, 1.05, block.id, 1);
                    colour = glm::mix(colour, colour * rgb(0xF2DFC4), hashUnit(block.id, 2) * 0.7);
                    const double wobble = 0.0006 * fractalNoise(p, 40, 2, 17);
                    const double joint = smoothStep(0.0012, 0.0034, block.joint + wobble);
                    colour = glm::mix(colour * rgb(0x8A7A66), colour, joint);
                    colour *= 1 + 0.05 * (1 - smoothStep(0.003, 0.008, block.joint)) * joint;
                }
                return colour;
            }};
}

TextureRecipe marble(Colour light, Colour dark, Colour vein, int scale, std::uint32_t seed) {
    return {512, [=](Vec2 p) {
                const Vec2 warp(fractalNoise(p, scale, 5, seed + 1),
                                fractalNoise(p, scale, 5, seed + 2));
                const double clouds = fractalNoise(p + warp * (0.25 / scale), scale, 5, seed + 3);
                Colour colour = glm::mix(light, dark, smoothStep(-0.6, 0.7, clouds));
                // Veins are where a warped noise crosses zero; their strength comes and goes.
                const double wide =
                    std::abs(fractalNoise(p + warp * (0.5 / scale), scale, 4, seed + 4));
                const double fine =
                    std::abs(fractalNoise(p + warp * (0.4 / scale), 2 * scale, 4, seed + 5));
                const double gate = smoothStep(-0.2, 0.5, fractalNoise(p, scale, 3, seed + 6));
                const double strength =
                    0.75 * gate * (1 - smoothStep(0.0, 0.09, wide)) +
                    0.40 * (1 - smoothStep(0.0, 0.045, fine)) * (0.3 + 0.7 * gate);
                colour = glm::mix(colour, vein, std::min(0.85, strength));
                return colour * (1 + 0.02 * fractalNoise(p, 64, 2, seed + 7));
            }};
}

TextureRecipe plaster(Colour coat, Colour undercoat) {
    return {1024, [=](Vec2 p) {
                const double broad = fractalNoise(p, 2, 6, 31, 0.55);
                const double worn = fractalNoise(p, 4, 7, 32, 0.6);
                Colour colour = glm::mix(coat, coat * rgb(0xEBD9C0), smoothStep(-0.5, 0.6, broad));
                colour = glm::mix(colour, undercoat, 0.8 * smoothStep(0.42, 0.62, worn));
                colour *=
                    1 - 0.10 * smoothStep(0.33, 0.42, worn) * (1 - smoothStep(0.42, 0.5, worn));
                // Rain leaves streaks: noise that is stretched along the wall's height.
                const double streaks = fractalNoise(Vec2(p.x, 0.31), 14, 4, 33) * 0.6 + broad * 0.5;
                colour *= 1 - 0.14 * smoothStep(0.15, 0.9, streaks);
                const double crack = std::abs(fractalNoise(p + Vec2(0.02 * worn), 3, 6, 34));
                colour *=
                    1 - 0.25 * (1 - smoothStep(0.0, 0.008, crack)) * smoothStep(0.0, 0.4, broad);
                return colour * (1 + 0.05 * fractalNoise(p, 80, 3, 35));
            }};
}

TextureRecipe bricks() {
    return {
        1024, [](Vec2 p) {
            const Block block = findBlock(p, 16, 4, 0.5);
            const double wobble = 0.0016 * fractalNoise(p, 40, 3, 41);
            const double brick = smoothStep(0.0035, 0.0065, block.joint + wobble);
            Colour colour = glm::mix(rgb(0xB06A48), rgb(0xC98F66), hashUnit(block.id, 3));
            colour =
                glm::mix(colour, rgb(0x8C5340), 0.6 * smoothStep(0.7, 1.0, hashUnit(block.id, 4)));
            colour *= 1 + 0.10 * fractalNoise(p, 24, 4, 42);
            const Colour lime = rgb(0xCDBD9F) * (1 + 0.06 * fractalNoise(p, 64, 3, 43));
            colour = glm::mix(lime, colour, brick);
            return glm::mix(colour, lime, 0.45 * smoothStep(0.1, 0.8, fractalNoise(p, 3, 5, 44)));
        }};
}

} // namespace dirt::generate
