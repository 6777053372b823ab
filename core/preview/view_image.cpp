#include "core/preview/view_image.h"

#include <algorithm>
#include <cmath>

namespace dirt {

namespace {

/// The border before \p slope, and the part of the tile after it. Beyond the rim the outermost tile
/// goes on.
double placeOf(const std::vector<float>& borders, double slope) {
    const auto after = std::upper_bound(borders.begin() + 1, borders.end() - 1, slope);
    const size_t i = (size_t) (after - borders.begin()) - 1;
    const double from = (double) borders[i], to = (double) borders[i + 1];
    return (double) i + (slope - from) / (to - from);
}

glm::dvec3 toView(const View& view, glm::dvec3 p) {
    return {p[view.axisX], p[view.axisY], (double) view.signW * p[view.axisW]};
}

} // namespace

glm::dvec2 slopesInTiles(const View& view, glm::dvec2 slopes) {
    return {placeOf(view.s, slopes.x), placeOf(view.t, slopes.y)};
}

std::optional<glm::dvec2> inTiles(const View& view, glm::dvec3 point) {
    const glm::dvec3 p = toView(view, point);
    if (!(p.z > 0.0)) return {};
    return slopesInTiles(view, {p.x / p.z, p.y / p.z});
}

std::vector<glm::dvec2> imageOf(const View& view, const Ray& ray, double begin, double end) {
    const glm::dvec3 o = toView(view, glm::dvec3(ray.origin));
    const glm::dvec3 d = toView(view, glm::dvec3(ray.direction));
    // Far away a ray's image tends to that of its direction; so it does from the eye.
    const auto slopes = [&](double t) -> std::optional<glm::dvec2> {
        glm::dvec3 p = std::isinf(t) ? d : o + t * d;
        if (p == glm::dvec3(0.0)) p = d;
        if (!(p.z > 0.0)) return {};
        return glm::dvec2(p.x / p.z, p.y / p.z);
    };
    const auto from = slopes(begin), to = slopes(end);
    if (!from || !to) return {};
    if (*from == *to) return {slopesInTiles(view, *from)};
    // A line in slopes bends where the last tiles are cut at the rim, which are shown as wide as
    // all.
    constexpr int kPieces = 64;
    std::vector<glm::dvec2> points;
    for (int i = 0; i <= kPieces; ++i)
        points.push_back(slopesInTiles(view, *from + (*to - *from) * ((double) i / kPieces)));
    return points;
}

glm::dvec2 ViewWindow::at(glm::dvec2 tiles) const {
    const double scale = (double) enlarged / reduced;
    return glm::dvec2(left, top) + (tiles - glm::dvec2(column, row)) * scale;
}

Box ViewWindow::cell(int level, int cellColumn, int cellRow) const {
    const auto pixel = [&](int tile, int first, int count) {
        return std::clamp(tile - first, 0, count) * enlarged / reduced;
    };
    const int x0 = pixel(cellColumn << level, column, columns);
    const int x1 = pixel((cellColumn + 1) << level, column, columns);
    const int y0 = pixel(cellRow << level, row, rows);
    const int y1 = pixel((cellRow + 1) << level, row, rows);
    return {left + x0, top + y0, std::max(x1 - x0, 1), std::max(y1 - y0, 1)};
}

ViewWindow wholeView(const View& view, int enlarged) {
    ViewWindow window;
    window.columns = view.columns;
    window.rows = view.rows;
    window.enlarged = enlarged;
    return window;
}

} // namespace dirt
