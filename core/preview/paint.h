#pragma once

#include "core/preview/preview.h"

#include <glm/vec3.hpp>

namespace dirt {

/// A value a pixel, drawn in false colours from the least to the largest. NaN is black: nothing.
struct HeatMap {
    int width, height;
    std::vector<double> values;
    std::string unit;

    HeatMap(int width, int height, std::string unit);
    double& at(int x, int y) { return values[(size_t) y * (size_t) width + (size_t) x]; }
    /// \p fromZero: the scale begins at 0, for counts.
    PreviewPicture paint(bool fromZero) const;
};

/// A colour that tells one id from its neighbours; black where there is none.
glm::u8vec3 idColour(uint32_t id);

/// Sets a pixel.
void put(PreviewPicture& picture, int x, int y, glm::u8vec3 colour);

/// A picture with nothing in it yet.
PreviewPicture blank(int width, int height);

} // namespace dirt
