#include "core/preview/ray_colours.h"
#include "core/preview/ray_panels.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace dirt {

namespace {

// Pixels along the panel: of views of few tiles, and at most.
constexpr int kSmallPanel = 576, kLargePanel = 1152;
constexpr int kFewTiles = 72; ///< along a view that is shown whole
constexpr int kAround = 4;    ///< tiles shown around those that a ray looks at

/// Columns or rows [from, to] of a view of \p count, cut to what the ray looks at if they are many.
std::pair<int, int> shownRange(int from, int to, int count) {
    if (count <= kFewTiles) return {0, count - 1};
    return {std::max(from - kAround, 0), std::min(to + kAround, count - 1)};
}

std::pair<int, int> scaleFor(int tiles) {
    if (tiles <= kFewTiles) return {std::min(kSmallPanel / tiles, 48), 1};
    if (tiles <= kLargePanel) return {kLargePanel / tiles, 1};
    return {1, (tiles + kLargePanel - 1) / kLargePanel};
}

std::vector<CellLook> fromTheTop(const ViewTrail& trail) {
    std::vector<CellLook> cells = trail.cells;
    std::stable_sort(cells.begin(), cells.end(),
                     [](const CellLook& a, const CellLook& b) { return a.level > b.level; });
    return cells;
}

void drawContents(Canvas& canvas, const DrawnRay& ray, const ViewTrail& trail,
                  const ViewWindow& window) {
    const int view = trail.span.view, columns = ray.grid.views[(size_t) view].columns;
    const bool gaps = window.enlarged >= 6;
    for (int row = window.row; row < window.row + window.rows; ++row)
        for (int column = window.column; column < window.column + window.columns; ++column) {
            Box box = window.cell(0, column, row);
            if (gaps) --box.width, --box.height;
            const bool empty = ray.grid.bounds(view, row * columns + column).empty();
            canvas.fill(box, empty ? kEmptyTile : kFilledTile);
        }
}

/// In the box's corner, as large as there is room.
void drawNumber(Canvas& canvas, Box box, int number, Colour colour) {
    const std::string text = std::to_string(number);
    for (const int size : {2, 1}) {
        if (box.width < textWidth(text, size) + 5 || box.height < textHeight(size) + 3) continue;
        canvas.text(box.left + 4, box.top + 4, text, colour, size);
        return;
    }
}

void drawCell(Canvas& canvas, const CellLook& cell, const ViewWindow& window) {
    const Box box = window.cell(cell.level, cell.column, cell.row);
    if (!cell.passedOver) {
        if (cell.level > 0) canvas.frame(box, kLookedInto, window.enlarged >= 8 ? 2 : 1);
        return;
    }
    canvas.fill(box, kPassedOver);
    if (std::min(box.width, box.height) > 2) canvas.frame(box, kPassedOverRim);
    drawNumber(canvas, box, cell.level, kPassedOverRim);
}

void drawVisits(Canvas& canvas, const DrawnRay& ray, const ViewTrail& trail,
                const ViewWindow& window) {
    for (size_t i = 0; i < trail.tiles.size(); ++i) {
        const TileTrail& tile = trail.tiles[i];
        const Box box = window.cell(0, tile.column, tile.row);
        canvas.fill(box, kVisited);
        canvas.frame(box, kVisitedRim, window.enlarged >= 16 ? 2 : 1);
        drawNumber(canvas, box, (int) i + 1, kWords);
    }
    // The hit's record is filed under a tile of one of the views.
    const Hit& hit = ray.trail.hit;
    if (ray.trail.maxT || !hit.found() || (int) hit.view != trail.span.view) return;
    const int columns = ray.grid.views[hit.view].columns;
    canvas.frame(window.cell(0, (int) hit.tile % columns, (int) hit.tile / columns), kHitMark,
                 window.enlarged >= 16 ? 2 : 1);
}

void drawPart(Canvas& canvas, const DrawnRay& ray, const ViewTrail& trail, const ViewWindow& window,
              double begin, double end, Colour colour) {
    const View& view = ray.grid.views[(size_t) trail.span.view];
    const auto points = imageOf(view, ray.trail.ray, begin, end);
    for (size_t i = 1; i < points.size(); ++i)
        canvas.line(window.at(points[i - 1]), window.at(points[i]), colour, 2);
    if (points.size() == 1) canvas.ring(window.at(points[0]), 4, colour);
}

void drawRayImage(Canvas& canvas, const DrawnRay& ray, const ViewTrail& trail,
                  const ViewWindow& window) {
    const double end = ray.end(), begin = trail.span.begin, last = trail.span.end;
    if (end < last) drawPart(canvas, ray, trail, window, std::max(begin, end), last, kRayBeyond);
    if (end >= begin) drawPart(canvas, ray, trail, window, begin, std::min(end, last), kRayLine);
    const View& view = ray.grid.views[(size_t) trail.span.view];
    const glm::dvec3 origin(ray.trail.ray.origin), direction(ray.trail.ray.direction);
    const auto start = inTiles(view, origin);
    if (begin == 0.0 && start) canvas.ring(window.at(*start), 5, kRayLine);
    if (!ray.hits() || !(end >= begin && end <= last)) return;
    if (const auto hit = inTiles(view, origin + end * direction))
        canvas.cross(window.at(*hit), 7, kHitMark, 3);
}

} // namespace

ViewWindow windowOf(const View& view, const ViewTrail& trail) {
    int left = view.columns, right = -1, top = view.rows, bottom = -1;
    const auto take = [&](int level, int column, int row) {
        left = std::min(left, column << level);
        top = std::min(top, row << level);
        right = std::max(right, std::min((column + 1) << level, view.columns) - 1);
        bottom = std::max(bottom, std::min((row + 1) << level, view.rows) - 1);
    };
    for (const CellLook& cell : trail.cells)
        if (cell.level == 0 || cell.passedOver) take(cell.level, cell.column, cell.row);
    if (right < left) right = view.columns - 1, bottom = view.rows - 1, left = top = 0;
    const auto [column0, column1] = shownRange(left, right, view.columns);
    const auto [row0, row1] = shownRange(top, bottom, view.rows);
    ViewWindow window;
    window.column = column0;
    window.row = row0;
    window.columns = column1 - column0 + 1;
    window.rows = row1 - row0 + 1;
    std::tie(window.enlarged, window.reduced) = scaleFor(std::max(window.columns, window.rows));
    return window;
}

void drawTilesPanel(Canvas whole, const DrawnRay& ray, const ViewTrail& trail,
                    const ViewWindow& window) {
    Canvas canvas = whole.within(window.box());
    drawContents(canvas, ray, trail, window);
    for (const CellLook& cell : fromTheTop(trail)) drawCell(canvas, cell, window);
    drawVisits(canvas, ray, trail, window);
    drawRayImage(canvas, ray, trail, window);
}

} // namespace dirt
