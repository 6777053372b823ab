#include "core/preview/paint.h"

#include "core/compare/colour_map.h"
#include "shaders/shared/random.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace dirt {

HeatMap::HeatMap(int width, int height, std::string unit)
    : width(width), height(height),
      values((size_t) width * (size_t) height, std::numeric_limits<double>::quiet_NaN()),
      unit(std::move(unit)) {}

PreviewPicture HeatMap::paint(bool fromZero) const {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const double value : values)
        if (std::isfinite(value)) {
            low = std::min(low, value);
            high = std::max(high, value);
        }
    PreviewPicture picture = blank(width, height);
    picture.values = {{{0, 0, width, height}, 1, 1, values, unit}};
    if (low > high) {
        picture.scale = "nothing";
        return picture;
    }
    if (fromZero) low = std::min(low, 0.0);
    picture.scale = scaleNumber(low) + " to " + scaleNumber(high) + " " + unit;
    picture.colours = FalseColours{low, high, unit};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const double value = values[(size_t) y * (size_t) width + (size_t) x];
            if (std::isnan(value)) continue;
            const double part = high > low ? (std::min(value, high) - low) / (high - low) : 1.0;
            picture.set(x, y, heatColour(part));
        }
    return picture;
}

Colour heatColour(double part) {
    // The lowest colour is black, as nothing is: the scale begins a little above.
    return falseColour(0.1 + 0.9 * part);
}

Colour idColour(uint32_t id) {
    if (id == kNoPrimitive) return {0, 0, 0};
    Colour colour;
    for (int c = 0; c < 3; ++c)
        colour[c] = (uint8_t) (64.0f + 191.0f * randomUnit(id, 0, 0, (uint) c, 0));
    return colour;
}

PreviewPicture blank(int width, int height) {
    return {Picture(width, height), "", {}, {}, {}, {}, false};
}

std::string scaleNumber(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
}

} // namespace dirt
