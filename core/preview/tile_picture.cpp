#include "core/preview/tile_picture.h"

#include "core/preview/paint.h"
#include "core/preview/ray_colours.h"
#include "core/preview/view_image.h"

#include <algorithm>
#include <cmath>

namespace dirt {

namespace {

// Pixels: of a side of the drawings, of the tile within, around them, and for numbers.
constexpr int kSide = 576, kTile = 512, kNumbers = 110;

Colour entryColour(const TileEntry& entry) {
    return entry.isRight() ? idColour(entry.id) : kHitMark;
}

/// The polygons, within the tile and its guard band.
void drawPolygons(Canvas canvas, const View& view, const std::vector<TileEntry>& entries,
                  int column, int row, Box box) {
    canvas.fill(box, kEmptyTile);
    const int rim = (kSide - kTile) / 2;
    canvas.frame({box.left + rim, box.top + rim, kTile, kTile}, kVisitedRim);
    const auto at = [&](glm::dvec3 corner) {
        const glm::dvec2 inTile = slopesInTiles(view, {corner.x / corner.z, corner.y / corner.z}) -
                                  glm::dvec2(column, row);
        return glm::dvec2(box.left + rim, box.top + rim) + inTile * (double) kTile;
    };
    Canvas inside = canvas.within(box);
    for (const TileEntry& entry : entries)
        for (size_t i = 0; i < entry.polygon.size(); ++i) { // lines to the eye have no end
            const glm::dvec3 a = entry.polygon[i];
            const glm::dvec3 b = entry.polygon[(i + 1) % entry.polygon.size()];
            inside.line(at(a), at(b), entryColour(entry), entries.size() < 100 ? 2 : 1);
        }
}

/// The depths, one column an entry, over the bins.
void drawDepths(Canvas canvas, const Grid& grid, const DepthBounds& bounds,
                const std::vector<TileEntry>& entries, Box box) {
    const double low = (double) bounds.near, high = (double) bounds.far;
    const auto y = [&](double depth) {
        const double part = high > low ? (depth - low) / (high - low) : 0.5;
        return box.bottom() - 1 - part * (box.height - 1);
    };
    canvas.fill(box, kEmptyTile);
    const int bins = grid.settings.bins;
    for (int b = 1; b < bins && high > low; ++b)
        canvas.fill({box.left, (int) y(low + (high - low) * b / bins), box.width, 1}, kFilledTile);
    for (size_t i = 0; i < entries.size(); ++i) {
        const TileEntry& entry = entries[i];
        const int left = box.left + (int) (i * (size_t) box.width / entries.size());
        const int right = box.left + (int) ((i + 1) * (size_t) box.width / entries.size());
        const double near = entry.isDue ? (double) entry.depths.near : low;
        const double far = entry.isDue ? (double) entry.depths.far : high;
        const int top = (int) std::floor(y(far)), bottom = (int) std::ceil(y(near));
        const int width = std::clamp(right - left - 2, 1, 24);
        canvas.within(box).fill({left, top, width, std::max(bottom - top, 2)}, entryColour(entry));
    }
    const std::string far = scaleNumber(high), near = scaleNumber(low);
    canvas.text(box.left - 8 - textWidth(far), box.top, far, kFaintWords);
    canvas.text(box.left - 8 - textWidth(near), box.bottom() - 16, near, kFaintWords);
}

} // namespace

Picture drawEntries(const Grid& grid, const std::vector<TileEntry>& entries, int view, int column,
                    int row, const std::string& title) {
    const View& seen = grid.views[(size_t) view];
    const int head = kPictureMargin + textHeight() + 8;
    using Shape = Key::Shape;
    const std::vector<Key> keys{
        {Shape::box, kEmptyTile, kVisitedRim,
         "the tile, and the corners of what it lists in it; a colour for each primitive"},
        {Shape::box, kEmptyTile, kFilledTile, "its bins, and the depths of the same, by id"},
        {Shape::box, kHitMark, kHitMark, "listed where it is not due, or due and not listed"}};
    const Box left{kPictureMargin, head, kSide, kSide};
    const Box right{left.right() + kNumbers + kPictureMargin, head, kSide, kSide};
    Picture picture(std::max({right.right() + kPictureMargin, textWidth(title) + 2 * kPictureMargin,
                              widthOf(keys) + 2 * kPictureMargin}),
                    left.bottom() + kPictureMargin + heightOf(keys) + kPictureMargin);
    Canvas canvas(picture);
    canvas.fill({0, 0, picture.width, picture.height}, kBackground);
    canvas.text(kPictureMargin, kPictureMargin, title, kWords);
    drawPolygons(canvas, seen, entries, column, row, left);
    const DepthBounds& bounds = grid.bounds(view, row * seen.columns + column);
    if (!bounds.empty()) drawDepths(canvas, grid, bounds, entries, right);
    drawKeys(canvas, kPictureMargin, left.bottom() + kPictureMargin, keys);
    return picture;
}

} // namespace dirt
