#include "core/preview/marks.h"

#include <algorithm>
#include <cmath>

namespace dirt {

namespace {

constexpr int kRing = 12; ///< pixels around a pixel that is marked

Box boxBetween(glm::dvec2 from, glm::dvec2 to) {
    const int left = (int) std::floor(from.x), top = (int) std::floor(from.y);
    return {left, top, std::max((int) std::floor(to.x) - left, 1),
            std::max((int) std::floor(to.y) - top, 1)};
}

/// A frame around the pixel, and four lines that point at it.
void drawPixel(Canvas& canvas, glm::dvec2 corner, int times, Colour colour) {
    const Box box = boxBetween(corner, corner + glm::dvec2(times));
    canvas.frame({box.left - 2, box.top - 2, box.width + 4, box.height + 4}, kBackground, 2);
    canvas.frame({box.left - 1, box.top - 1, box.width + 2, box.height + 2}, colour);
    const glm::dvec2 middle = corner + 0.5 * glm::dvec2(times);
    for (const glm::dvec2 way : {glm::dvec2(1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
        const glm::dvec2 near = middle + way * (0.5 * times + 4.0);
        canvas.line(near, near + way * (double) kRing, kBackground, 4);
        canvas.line(near, near + way * (double) kRing, colour, 2);
    }
}

} // namespace

void drawMarks(Canvas& canvas, const std::vector<Mark>& marks, glm::dvec2 corner, int times) {
    const int width = times >= 12 ? 2 : 1;
    // Lines have dark ones beneath them, as pictures may be bright: all of those first.
    for (const bool shadows : {true, false})
        for (const Mark& mark : marks) {
            const glm::dvec2 from = corner + mark.from * (double) times;
            const glm::dvec2 to = corner + mark.to * (double) times;
            const Colour colour = shadows ? kBackground : mark.colour;
            switch (mark.shape) {
            case Mark::Shape::box:
                canvas.frame(boxBetween(from, to), colour,
                             shadows && times >= 8 ? 2 * width : width);
                break;
            case Mark::Shape::line:
                canvas.line(from, to, colour, (times >= 4 ? 2 : 1) + (shadows ? 2 : 0));
                break;
            case Mark::Shape::cross:
                canvas.cross(from, shadows ? 6 : 5, colour, shadows ? 5 : 2);
                break;
            case Mark::Shape::pixel:
                if (!shadows) drawPixel(canvas, from, times, colour);
                break;
            }
        }
}

} // namespace dirt
