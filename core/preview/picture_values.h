#pragma once

#include "core/base/image.h"
#include "core/preview/canvas.h"

#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace dirt {

/// The numbers that a part of a picture stands for: an element for each square of its pixels.
struct PictureValues {
    Box pixels;                  ///< that the part takes
    int times = 1;               ///< pixels along an element
    int channels = 1;            ///< numbers an element: 3 of vectors and colours
    std::vector<double> numbers; ///< rows of elements; NaN: nothing is there
    std::string unit;            ///< "entries a tile"
    int view = -1;               ///< whose cells the elements are; -1: they are pixels
    int level = 0;               ///< of the pyramid

    int columns() const { return pixels.width / times; }
    int rows() const { return pixels.height / times; }
    /// The element at a pixel of the picture, if the part holds it.
    std::optional<glm::ivec2> elementAt(int x, int y) const;
    /// Its numbers, each as exact as it is: "0.25, 0.5, 1", or "nothing".
    std::string textOf(glm::ivec2 element) const;
};

/// The radiance of an image's pixels.
PictureValues valuesOf(const Image& image);

/// The part of a picture's values that is in \p box of its elements, a part by itself.
PictureValues partOf(const PictureValues& whole, Box box);

} // namespace dirt
