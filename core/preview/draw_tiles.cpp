#include "core/base/error.h"
#include "core/dump/dump.h"
#include "core/preview/pixel_pictures.h"
#include "core/preview/sheet.h"

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

namespace dirt {

namespace {

/// Calls \p visit(x, y, view, tile) for all cells of a level.
template <typename Visit>
void forEachCell(const Grid& grid, const Sheet& sheet, const Visit& visit) {
    for (size_t view = 0; view < grid.views.size(); ++view)
        for (int row = 0; row < sheet.rows; ++row)
            for (int column = 0; column < sheet.columns; ++column)
                visit(sheet.left(view) + column, sheet.top(view) + row, view,
                      row * sheet.columns + column);
}

PreviewPicture drawDepths(const Grid& grid, int level, bool near) {
    const Sheet sheet(grid, level);
    HeatMap map(sheet.width(), sheet.height(grid), "in the grid frame");
    forEachCell(grid, sheet, [&](int x, int y, size_t view, int cell) {
        const DepthBounds& bounds =
            grid.pyramids[view].levels[(size_t) level].bounds[(size_t) cell];
        if (!bounds.empty()) map.at(x, y) = (double) (near ? bounds.near : bounds.far);
    });
    return map.paint(false);
}

PreviewPicture drawEntryCounts(const Grid& grid, int bin) {
    const Sheet sheet(grid, 0);
    HeatMap map(sheet.width(), sheet.height(grid),
                bin < 0 ? "entries a tile" : "entries of bin " + std::to_string(bin));
    forEachCell(grid, sheet, [&](int x, int y, size_t view, int tile) {
        size_t entries = 0;
        for (int b = 0; b < grid.settings.bins; ++b)
            if (bin < 0 || b == bin) entries += grid.list((int) view, tile, b).size();
        if (entries > 0) map.at(x, y) = (double) entries;
    });
    return map.paint(true);
}

/// The lowest id of the first bin that lists any.
PreviewPicture drawFirst(const Grid& grid) {
    const Sheet sheet(grid, 0);
    const int width = sheet.width(), height = sheet.height(grid);
    std::vector<uint32_t> first((size_t) width * (size_t) height, kNoPrimitive);
    forEachCell(grid, sheet, [&](int x, int y, size_t view, int tile) {
        for (int b = 0; b < grid.settings.bins; ++b) {
            const auto list = grid.list((int) view, tile, b);
            if (list.empty()) continue;
            first[(size_t) y * (size_t) width + (size_t) x] =
                *std::min_element(list.begin(), list.end());
            return;
        }
    });
    return ids(width, height, [&](size_t i) { return first[i]; });
}

PreviewPicture drawCells(const Grid& grid, const PreviewRequest& request) {
    const std::string_view name = request.kind->name;
    if (name == "first") return drawFirst(grid);
    if (name == "entries") return drawEntryCounts(grid, request.bin);
    return drawDepths(grid, request.level, name == "near");
}

} // namespace

PreviewPicture drawTiles(const Grid& grid, const PreviewRequest& request) {
    const int levels = (int) grid.pyramids[0].levels.size();
    if (request.level >= levels)
        throw InputError("--level " + std::to_string(request.level) + ": the pyramid has " +
                         std::to_string(levels) + ", counted from 0");
    if (request.bin >= grid.settings.bins)
        throw InputError("--bin " + std::to_string(request.bin) + ": a tile has " +
                         std::to_string(grid.settings.bins) + ", counted from 0");
    PreviewPicture picture = drawCells(grid, request);
    const Sheet sheet(grid, request.level);
    const PictureValues whole = std::move(picture.values.front());
    picture.values.clear();
    for (size_t view = 0; view < grid.views.size(); ++view) {
        const Box box{sheet.left(view), sheet.top(view), sheet.columns, sheet.rows};
        if (grid.views.size() > 1) picture.parts.push_back({box, viewName(grid, view)});
        picture.values.push_back(partOf(whole, box));
        picture.values.back().view = (int) view;
        picture.values.back().level = request.level;
    }
    return picture;
}

} // namespace dirt
