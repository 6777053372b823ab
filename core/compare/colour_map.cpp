#include "core/compare/colour_map.h"

#include <algorithm>
#include <array>

namespace dirt {

namespace {

/// CIELab L* = 98 t, hue = 290° + 165° t, chroma 72 sin(π t^0.8)^0.9 (24 at the end), in sRGB at
/// t = 0, 1/8 … 1, clipped to the gamut.
constexpr std::array<std::array<double, 3>, 9> kMap = {{{0, 0, 0},
                                                        {43, 17, 78},
                                                        {113, 0, 105},
                                                        {177, 0, 105},
                                                        {220, 41, 94},
                                                        {240, 105, 92},
                                                        {245, 160, 114},
                                                        {244, 209, 169},
                                                        {255, 249, 203}}};

} // namespace

glm::u8vec3 falseColour(double value) {
    const double place = std::clamp(value, 0.0, 1.0) * (double) (kMap.size() - 1);
    const size_t i = std::min((size_t) place, kMap.size() - 2);
    const double part = place - (double) i;
    glm::u8vec3 colour;
    for (int c = 0; c < 3; ++c)
        colour[c] = (uint8_t) (kMap[i][c] + (kMap[i + 1][c] - kMap[i][c]) * part + 0.5);
    return colour;
}

} // namespace dirt
