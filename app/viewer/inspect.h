#pragma once

#include "app/viewer/view_picture.h"

#include <array>
#include <optional>
#include <string>

#include <glm/vec2.hpp>

namespace dirt {

/// What stands at a pixel of a picture.
struct Inspection {
    std::string text;                       ///< where it is, and its exact values; empty: nothing
    std::optional<glm::dvec2> place;        ///< of a pixel: in parts of the image's size
    std::optional<std::array<int, 3>> tile; ///< of a tile: view, column and row
};

/// (\p x, \p y): a pixel of the picture, (0, 0) its top left one.
Inspection inspect(const ViewPicture& shown, int x, int y);

} // namespace dirt
