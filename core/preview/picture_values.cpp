#include "core/preview/picture_values.h"

#include <charconv>
#include <cmath>

namespace dirt {

std::optional<glm::ivec2> PictureValues::elementAt(int x, int y) const {
    if (x < pixels.left || y < pixels.top || x >= pixels.right() || y >= pixels.bottom()) return {};
    return glm::ivec2((x - pixels.left) / times, (y - pixels.top) / times);
}

std::string PictureValues::textOf(glm::ivec2 element) const {
    const size_t first =
        ((size_t) element.y * (size_t) columns() + (size_t) element.x) * (size_t) channels;
    std::string text;
    for (size_t c = 0; c < (size_t) channels; ++c) {
        const double number = numbers[first + c];
        if (channels == 1 && std::isnan(number)) return "nothing";
        // Most are floats: the digits that tell one from all others.
        char digits[32];
        const float single = (float) number;
        const auto end = (double) single == number
                             ? std::to_chars(digits, std::end(digits), single).ptr
                             : std::to_chars(digits, std::end(digits), number).ptr;
        text += (c > 0 ? ", " : "") + std::string(digits, end);
    }
    return unit.empty() ? text : text + " " + unit;
}

PictureValues valuesOf(const Image& image) {
    PictureValues values{{0, 0, image.width, image.height}, 1, 3, {}, ""};
    values.numbers.reserve(3 * image.pixels.size());
    for (const glm::vec3& pixel : image.pixels)
        for (int c = 0; c < 3; ++c) values.numbers.push_back((double) pixel[c]);
    return values;
}

PictureValues partOf(const PictureValues& whole, Box box) {
    PictureValues part{box, 1, whole.channels, {}, whole.unit, whole.view, whole.level};
    const auto channels = (size_t) whole.channels;
    for (int y = box.top; y < box.bottom(); ++y) {
        const auto row =
            whole.numbers.begin() +
            (std::ptrdiff_t)(((size_t) y * (size_t) whole.columns() + (size_t) box.left) *
                             channels);
        part.numbers.insert(part.numbers.end(), row,
                            row + (std::ptrdiff_t)((size_t) box.width * channels));
    }
    return part;
}

} // namespace dirt
