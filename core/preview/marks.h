#pragma once

#include "core/preview/ray_colours.h"

#include <vector>

#include <glm/vec2.hpp>

namespace dirt {

/// Something that is marked in a picture, in the picture's pixels before it is enlarged: (0, 0) is
/// the top left corner of the first.
struct Mark {
    enum class Shape {
        box,   ///< from corner to corner
        line,  ///< from end to end
        cross, ///< at \p from
        pixel  ///< the one whose corner is at \p from, made easy to find
    };
    Shape shape;
    glm::dvec2 from, to;
    Colour colour;
    int view = -1; ///< in whose part of the picture it is; -1: there are no such parts
};

/// All marks of a picture, and what they mean.
struct Marks {
    std::vector<Mark> marks;
    std::vector<Key> keys;

    bool empty() const { return marks.empty() && keys.empty(); }
};

/// Draws marks over a picture that stands at \p corner, enlarged \p times.
void drawMarks(Canvas& canvas, const std::vector<Mark>& marks, glm::dvec2 corner, int times);

} // namespace dirt
