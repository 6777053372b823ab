#include "app/viewer/inspect.h"

namespace dirt {

namespace {

std::string textOf(glm::ivec2 at) {
    return "(" + std::to_string(at.x) + ", " + std::to_string(at.y) + ")";
}

Inspection inspectPixel(const PictureValues& values, glm::ivec2 at) {
    return {"pixel " + textOf(at) + ": " + values.textOf(at),
            (glm::dvec2(at) + 0.5) / glm::dvec2(values.columns(), values.rows()),
            {}};
}

Inspection inspectCell(const PictureValues& values, glm::ivec2 at) {
    const std::string view = "view " + std::to_string(values.view);
    const std::string text = values.textOf(at);
    if (values.level > 0)
        return {view + ", cell " + textOf(at) + " of level " + std::to_string(values.level) + ": " +
                    text,
                {},
                {}};
    return {view + ", tile " + textOf(at) + ": " + text, {}, std::array{values.view, at.x, at.y}};
}

} // namespace

Inspection inspect(const ViewPicture& shown, int x, int y) {
    if (!shown.picture.holds(x, y)) return {};
    if (!shown.image.pixels.empty()) {
        // The one pixel, so that no image has to be kept as numbers besides.
        const glm::vec3 pixel = shown.image.pixels[(size_t) y * (size_t) shown.width + (size_t) x];
        const PictureValues one = valuesOf({1, 1, {pixel}});
        return {"pixel " + textOf({x, y}) + ": " + one.textOf({0, 0}),
                (glm::dvec2(x, y) + 0.5) / glm::dvec2(shown.width, shown.height),
                {}};
    }
    for (const PictureValues& values : shown.values)
        if (const auto at = values.elementAt(x, y))
            return values.view < 0 ? inspectPixel(values, *at) : inspectCell(values, *at);
    return {};
}

} // namespace dirt
