#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "scenes/generate/noise.h"
#include "scenes/generate/numbers.h"
#include "scenes/generate/paint.h"

namespace dirt::generate {
namespace {

/// Whether two mirrored eighths of a medallion are inside, positive where they are.
double medallion(Vec2 p, double size) {
    const double angle = std::atan2(p.y, p.x);
    return size * (1 + 0.16 * std::cos(8 * angle)) - glm::length(p);
}

} // namespace

TextureRecipe speckledGlaze(Colour glaze, Colour speck) {
    return {512, [=](Vec2 p) {
                const double clouds = fractalNoise(p, 3, 4, 3001);
                Colour colour = glaze * (1 + 0.035 * clouds);
                const double fine = fractalNoise(p, 60, 2, 3002);
                const double large = fractalNoise(p, 26, 2, 3003);
                colour = glm::mix(colour, speck, 0.55 * smoothStep(0.62, 0.78, fine));
                return glm::mix(colour, speck, 0.65 * smoothStep(0.72, 0.82, large));
            }};
}

TextureRecipe carpet() {
    return {1024, [](Vec2 p) {
                const Colour red = rgb(0x8A4A40);
                const Colour navy = rgb(0x3B4758);
                const Colour cream = rgb(0xD8C6A0);
                const Colour rust = rgb(0xB07E5A);
                // Symmetric in both directions; distances from the middle and from the border.
                const Vec2 q = glm::abs(p - Vec2(0.5));
                const double edge = 0.5 - std::max(q.x, q.y);
                const auto cell = [](double x, double n) {
                    return x * n - std::floor(x * n) - 0.5;
                };
                Colour colour = red;
                if (edge < 0.13) { // border: a row of flowers between bands
                    const double along = q.x > q.y ? q.y : q.x;
                    const Vec2 c(cell(along + 0.0385, 13), (edge - 0.066) * 13);
                    colour = navy;
                    if (medallion(c, 0.36) > 0) colour = rust;
                    if (medallion(c, 0.20) > 0) colour = cream;
                    if (medallion(c, 0.08) > 0) colour = red;
                    if (edge < 0.014 || edge > 0.116) colour = cream;
                    if (edge < 0.008) colour = navy;
                } else {
                    const Vec2 c(cell(p.x, 9), cell(p.y, 9));
                    const int row = static_cast<int>(p.x * 9) + static_cast<int>(p.y * 9);
                    if (medallion(c, 0.22) > 0) colour = row % 2 == 0 ? navy : rust;
                    if (medallion(c, 0.09) > 0) colour = cream;
                    const double field = q.x + q.y;
                    if (field < 0.30) colour = navy;
                    if (field < 0.285 && field > 0.27) colour = cream;
                    if (field < 0.25) {
                        const double m = medallion(p - Vec2(0.5), 0.20);
                        colour = m > 0 ? (m > 0.03 ? rust : cream) : navy;
                        if (m > 0.09) colour = navy;
                        if (m > 0.13) colour = cream;
                        if (m > 0.16) colour = red;
                    }
                }
                // Knots, the dye's changing strength, and wear.
                const double knots = std::sin(804 * p.x) * std::sin(804 * p.y);
                const double abrash = periodicNoise({p.x * 2, p.y * 24}, 24, 3011);
                const double worn = fractalNoise(p, 5, 5, 3012, 0.6);
                colour *= 1 + 0.07 * knots + 0.06 * abrash + 0.10 * fractalNoise(p, 128, 2, 3013);
                return glm::mix(colour, rgb(0xA89880), 0.25 * smoothStep(0.2, 0.9, worn));
            }};
}

TextureRecipe pages() {
    return {128, [](Vec2 p) {
                const double leaf = periodicNoise({p.x * 2, p.y * 48}, 48, 3021);
                return rgb(0xE6DCC4) * (1 + 0.10 * leaf);
            }};
}

TextureRecipe landscape() {
    return {
        512, [](Vec2 p) {
            // An evening over hills and a lake, laid on with a broad brush.
            const Vec2 brush(0.012 * fractalNoise(p, 30, 2, 3031),
                             0.006 * fractalNoise(p, 44, 2, 3032));
            const Vec2 q = p + brush;
            Colour colour = glm::mix(rgb(0xF0C98A), rgb(0x6F95B4), smoothStep(0.45, 1.0, q.y));
            const double clouds = fractalNoise({q.x, q.y * 1.0}, 4, 4, 3033) + 1.1 * (q.y - 0.75);
            colour = glm::mix(colour, rgb(0xE8B58F), 0.7 * smoothStep(0.0, 0.5, clouds));
            const Colour hills[3] = {rgb(0x8FA3A8), rgb(0x6C8370), rgb(0x46603F)};
            for (int k = 0; k < 3; ++k) {
                const double line =
                    0.58 - 0.09 * k +
                    (0.07 - 0.01 * k) * fractalNoise({q.x, 0.3 + 0.2 * k}, 3, 4, 3034);
                if (q.y < line) colour = hills[k] * (0.9 + 0.35 * (q.y / line - 0.6));
            }
            if (q.y < 0.30) {
                const double ripples = periodicNoise({q.x * 6, q.y * 60}, 60, 3037);
                colour = glm::mix(rgb(0xC9A77A), rgb(0x5B7A86),
                                  smoothStep(0.3, 0.08, q.y) * 0.8 + 0.2 * ripples);
            }
            const double bank = 0.10 + 0.05 * fractalNoise({q.x, 0.9}, 3, 4, 3035);
            if (q.y < bank) colour = rgb(0x3C4A2A) * (1 + 0.4 * fractalNoise(q, 24, 3, 3036));
            return colour * (1 + 0.10 * fractalNoise(p, 60, 2, 3038));
        }};
}

} // namespace dirt::generate
