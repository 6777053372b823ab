#include "core/preview/canvas.h"

#include "core/preview/font.h"

#include <algorithm>
#include <cmath>

namespace dirt {

namespace {

/// Cuts the part [from, to] of a line a + t (b - a) to low <= coordinate <= high.
void cut(double a, double b, double low, double high, double& from, double& to) {
    if (a == b) {
        if (a < low || a > high) to = -1.0;
        return;
    }
    const double atLow = (low - a) / (b - a), atHigh = (high - a) / (b - a);
    from = std::max(from, std::min(atLow, atHigh));
    to = std::min(to, std::max(atLow, atHigh));
}

} // namespace

Canvas Canvas::within(Box part) const {
    Canvas canvas = *this;
    const int right = std::min(part.right(), part_.right());
    const int bottom = std::min(part.bottom(), part_.bottom());
    canvas.part_.left = std::max(part.left, part_.left);
    canvas.part_.top = std::max(part.top, part_.top);
    canvas.part_.width = right - canvas.part_.left;
    canvas.part_.height = bottom - canvas.part_.top;
    return canvas;
}

void Canvas::put(int x, int y, Colour colour) {
    if (x >= part_.left && y >= part_.top && x < part_.right() && y < part_.bottom())
        picture_.set(x, y, colour);
}

void Canvas::fill(Box box, Colour colour) {
    const int left = std::max(box.left, part_.left), right = std::min(box.right(), part_.right());
    const int bottom = std::min(box.bottom(), part_.bottom());
    for (int y = std::max(box.top, part_.top); y < bottom && left < right; ++y) {
        uint8_t* bytes = picture_.rgb.data() + picture_.place(left, y);
        for (int x = left; x < right; ++x, bytes += 3) {
            bytes[0] = colour.x;
            bytes[1] = colour.y;
            bytes[2] = colour.z;
        }
    }
}

void Canvas::frame(Box box, Colour colour, int thickness) {
    const int n = std::min({thickness, box.width, box.height});
    fill({box.left, box.top, box.width, n}, colour);
    fill({box.left, box.bottom() - n, box.width, n}, colour);
    fill({box.left, box.top, n, box.height}, colour);
    fill({box.right() - n, box.top, n, box.height}, colour);
}

void Canvas::dot(glm::dvec2 at, Colour colour, int thickness) {
    const int x = (int) std::floor(at.x - 0.5 * (thickness - 1));
    const int y = (int) std::floor(at.y - 0.5 * (thickness - 1));
    fill({x, y, thickness, thickness}, colour);
}

void Canvas::line(glm::dvec2 from, glm::dvec2 to, Colour colour, int thickness) {
    if (!std::isfinite(from.x) || !std::isfinite(from.y) || !std::isfinite(to.x) ||
        !std::isfinite(to.y))
        return;
    // Ends may be far outside: so many steps cannot be taken.
    double begin = 0.0, end = 1.0;
    cut(from.x, to.x, part_.left - thickness, part_.right() + thickness, begin, end);
    cut(from.y, to.y, part_.top - thickness, part_.bottom() + thickness, begin, end);
    if (begin > end) return;
    const glm::dvec2 way = to - from, first = from + begin * way, last = from + end * way;
    const double length = std::max(std::abs(last.x - first.x), std::abs(last.y - first.y));
    const int steps = (int) std::ceil(length);
    for (int i = 0; i <= steps; ++i)
        dot(steps == 0 ? first : first + (last - first) * ((double) i / steps), colour, thickness);
}

void Canvas::cross(glm::dvec2 at, int radius, Colour colour, int thickness) {
    const glm::dvec2 down(radius, radius), up(radius, -radius);
    line(at - down, at + down, colour, thickness);
    line(at - up, at + up, colour, thickness);
}

void Canvas::ring(glm::dvec2 at, int radius, Colour colour) {
    if (!std::isfinite(at.x) || !std::isfinite(at.y)) return;
    const int x0 = (int) std::clamp(at.x, -1e6, 1e6), y0 = (int) std::clamp(at.y, -1e6, 1e6);
    for (int y = -radius; y <= radius; ++y)
        for (int x = -radius; x <= radius; ++x)
            if (std::lround(std::sqrt((double) (x * x + y * y))) == radius)
                put(x0 + x, y0 + y, colour);
}

void Canvas::text(int x, int y, std::string_view text, Colour colour, int size) {
    for (const char letter : text) {
        for (int row = 0; row < kGlyphHeight; ++row)
            for (int column = 0; column < kGlyphWidth; ++column)
                if (isSet(letter, column, row))
                    fill({x + column * size, y + row * size, size, size}, colour);
        x += kAdvance * size;
    }
}

void Canvas::paste(const Picture& picture, int x, int y, int times) {
    if (times > 1) {
        for (int row = 0; row < picture.height; ++row)
            for (int column = 0; column < picture.width; ++column)
                fill({x + column * times, y + row * times, times, times}, picture.at(column, row));
        return;
    }
    // Rows as they are.
    const int left = std::max(x, part_.left), right = std::min(x + picture.width, part_.right());
    const int bottom = std::min(y + picture.height, part_.bottom());
    for (int row = std::max(y, part_.top); row < bottom && left < right; ++row)
        std::copy_n(picture.rgb.begin() + (std::ptrdiff_t) picture.place(left - x, row - y),
                    3 * (right - left),
                    picture_.rgb.begin() + (std::ptrdiff_t) picture_.place(left, row));
}

int textWidth(std::string_view text, int size) {
    return (int) text.size() * kAdvance * size;
}

int textHeight(int size) {
    return kLineHeight * size;
}

} // namespace dirt
