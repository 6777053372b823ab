#pragma once

#include "core/preview/paint.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace dirt {

/// The picture of a number for each pixel of the image; NaN where there is none.
template <typename Value>
PreviewPicture heat(const GridSettings& grid, const std::string& unit, bool fromZero,
                    const Value& valueOf) {
    HeatMap map(grid.width, grid.height, unit);
    for (size_t i = 0; i < map.values.size(); ++i) map.values[i] = valueOf(i);
    return map.paint(fromZero);
}

/// The picture of a vector for each pixel, from \p low to \p high; black where there is none.
template <typename Value>
PreviewPicture colours(const GridSettings& grid, glm::vec3 low, glm::vec3 high,
                       const std::string& scale, const Value& valueOf) {
    PreviewPicture picture = blank(grid.width, grid.height);
    picture.scale = scale;
    for (int y = 0; y < grid.height; ++y)
        for (int x = 0; x < grid.width; ++x) {
            const std::optional<glm::vec3> value =
                valueOf((size_t) y * (size_t) grid.width + (size_t) x);
            if (!value) continue;
            Colour colour;
            for (int c = 0; c < 3; ++c) {
                const float range = high[c] - low[c];
                const float part = range > 0.0f ? ((*value)[c] - low[c]) / range : 0.0f;
                colour[c] = (uint8_t) std::lround(255.0f * std::clamp(part, 0.0f, 1.0f));
            }
            picture.set(x, y, colour);
        }
    return picture;
}

/// A colour for each pixel's id.
template <typename Id>
PreviewPicture ids(const GridSettings& grid, const Id& idOf) {
    PreviewPicture picture = blank(grid.width, grid.height);
    picture.scale = "a colour for each primitive";
    for (int y = 0; y < grid.height; ++y)
        for (int x = 0; x < grid.width; ++x)
            picture.set(x, y, idColour(idOf((size_t) y * (size_t) grid.width + (size_t) x)));
    return picture;
}

} // namespace dirt
