#pragma once

#include "core/preview/picture.h"

#include <string>
#include <string_view>

#include <glm/vec2.hpp>

namespace dirt {

/// A rectangle of pixels.
struct Box {
    int left = 0, top = 0, width = 0, height = 0;

    int right() const { return left + width; }
    int bottom() const { return top + height; }
};

/// Draws into a picture, within a part of it: what lies outside is cut off. Points are in pixels,
/// (0, 0) the top left corner of the picture's first pixel.
class Canvas {
public:
    /// The whole of \p picture, which must outlive the canvas.
    explicit Canvas(Picture& picture)
        : picture_(picture), part_{0, 0, picture.width, picture.height} {}
    /// The same picture, of which only \p part can be drawn on.
    Canvas within(Box part) const;

    void fill(Box box, Colour colour);
    /// The rim of a box, \p thickness pixels inwards.
    void frame(Box box, Colour colour, int thickness = 1);
    /// Nothing where an end is infinite or NaN.
    void line(glm::dvec2 from, glm::dvec2 to, Colour colour, int thickness = 1);
    /// An X.
    void cross(glm::dvec2 at, int radius, Colour colour, int thickness = 2);
    void ring(glm::dvec2 at, int radius, Colour colour);
    /// One line of \p size times the font's size, from its top left corner.
    void text(int x, int y, std::string_view text, Colour colour, int size = kTextSize);
    /// Another picture, each of its pixels a square of \p times pixels.
    void paste(const Picture& picture, int x, int y, int times = 1);

    static constexpr int kTextSize = 2;

private:
    void put(int x, int y, Colour colour);
    void dot(glm::dvec2 at, Colour colour, int thickness);

    Picture& picture_;
    Box part_;
};

/// Pixels that a line of text takes.
int textWidth(std::string_view text, int size = Canvas::kTextSize);
int textHeight(int size = Canvas::kTextSize);

} // namespace dirt
