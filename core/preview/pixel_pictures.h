#pragma once

#include "core/preview/paint.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

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
    PictureValues values{{0, 0, grid.width, grid.height}, 1, 3, {}, ""};
    values.numbers.assign(picture.rgb.size(), std::numeric_limits<double>::quiet_NaN());
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
                values.numbers[picture.place(x, y) + (size_t) c] = (double) (*value)[c];
            }
            picture.set(x, y, colour);
        }
    picture.values.push_back(std::move(values));
    return picture;
}

/// A colour for each element's id.
template <typename Id>
PreviewPicture ids(int width, int height, const Id& idOf) {
    PreviewPicture picture = blank(width, height);
    picture.scale = "a colour for each primitive";
    HeatMap map(width, height, "");
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const uint32_t id = idOf((size_t) y * (size_t) width + (size_t) x);
            picture.set(x, y, idColour(id));
            if (id != kNoPrimitive) map.at(x, y) = (double) id;
        }
    picture.values = {{{0, 0, width, height}, 1, 1, std::move(map.values), ""}};
    return picture;
}

} // namespace dirt
