#include "app/viewer/placement.h"

#include <algorithm>

#include <glm/common.hpp>

namespace dirt {

namespace {

/// A picture's pixel is then larger than most windows.
constexpr double kLargestZoom = 4096.0;

/// No more beside the picture than there has to be.
void keepInside(Zoom& zoom) {
    const glm::dvec2 half(0.5 / zoom.times);
    zoom.centre = glm::clamp(zoom.centre, half, 1.0 - half);
}

} // namespace

Placement place(glm::dvec2 picture, glm::dvec2 room, const Zoom& zoom) {
    const double fit = std::min(room.x / picture.x, room.y / picture.y);
    const double scale = fit * zoom.times;
    return {0.5 * room - zoom.centre * picture * scale, scale};
}

void zoomAt(Zoom& zoom, double factor, glm::dvec2 point, glm::dvec2 picture, glm::dvec2 room) {
    const glm::dvec2 stays = place(picture, room, zoom).toPicture(point) / picture;
    zoom.times = std::clamp(zoom.times * factor, 1.0, kLargestZoom);
    const double scale = place(picture, room, zoom).scale;
    zoom.centre = stays - (point - 0.5 * room) / (picture * scale);
    keepInside(zoom);
}

void moveZoom(Zoom& zoom, glm::dvec2 by, glm::dvec2 picture, glm::dvec2 room) {
    zoom.centre -= by / (picture * place(picture, room, zoom).scale);
    keepInside(zoom);
}

} // namespace dirt
