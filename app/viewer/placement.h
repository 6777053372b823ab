#pragma once

#include <glm/vec2.hpp>

namespace dirt {

/// How much of a picture a window shows.
struct Zoom {
    double times = 1.0;          ///< 1: all of it
    glm::dvec2 centre{0.5, 0.5}; ///< of what is shown, in parts of the picture
};

/// Where a picture stands in a window: its pixel p at corner + scale p.
struct Placement {
    glm::dvec2 corner{0.0};
    double scale = 1.0;

    glm::dvec2 toPicture(glm::dvec2 window) const { return (window - corner) / scale; }
};

/// As large as the window of size \p room holds it without another shape, then zoomed.
Placement place(glm::dvec2 picture, glm::dvec2 room, const Zoom& zoom);

/// Zooms by \p factor around the point of the window that is to stay where it is; never out beyond
/// all of the picture.
void zoomAt(Zoom& zoom, double factor, glm::dvec2 point, glm::dvec2 picture, glm::dvec2 room);

/// Moves what is shown by so many pixels of the window.
void moveZoom(Zoom& zoom, glm::dvec2 by, glm::dvec2 picture, glm::dvec2 room);

} // namespace dirt
