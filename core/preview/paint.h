#pragma once

#include "core/preview/preview.h"

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

/// The false colour of a part of the scale, from 0 to 1: never black.
Colour heatColour(double part);

/// A colour that tells one id from its neighbours; black where there is none.
Colour idColour(uint32_t id);

/// A picture with nothing in it yet.
PreviewPicture blank(int width, int height);

/// A number in a picture or beside it, in six digits.
std::string scaleNumber(double value);

} // namespace dirt
