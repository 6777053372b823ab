#include "core/explain/listing.h"

#include "core/explain/clip_polygon.h"
#include "core/grid/scan.h"

#include <algorithm>

namespace dirt {

namespace {

/// The entry of a triangle in a tile by the rule; \p depths null: there is none.
TileEntry entryOf(const Grid& grid, const FrameGeometry& geometry, uint32_t id, int view, int tile,
                  const DepthInterval* depths) {
    const View& seen = grid.views[(size_t) view];
    const int columns = seen.columns;
    TileEntry entry;
    entry.id = id;
    entry.view = view;
    entry.column = tile % columns;
    entry.row = tile / columns;
    if (depths) {
        const BinMap bin(grid.bounds(view, tile), grid.settings.bins);
        entry.isDue = true;
        entry.depths = *depths;
        entry.firstBin = bin(depths->near);
        entry.lastBin = bin(depths->far);
        ViewTriangle setup;
        if (setUpTriangle(geometry.triangles[id], seen, setup))
            entry.polygon = clippedPolygon(setup, seen, entry.column, entry.row);
    }
    for (int b = 0; b < grid.settings.bins; ++b) {
        const auto list = grid.list(view, tile, b);
        if (std::find(list.begin(), list.end(), id) != list.end()) entry.bins.push_back(b);
    }
    return entry;
}

} // namespace

bool TileEntry::isRight() const {
    std::vector<int> due;
    for (int b = firstBin; isDue && b <= lastBin; ++b) due.push_back(b);
    return bins == due;
}

std::vector<TileEntry> entriesOfTile(const Grid& grid, const FrameGeometry& geometry, int view,
                                     int column, int row) {
    const int tile = row * grid.views[(size_t) view].columns + column;
    std::vector<bool> listed(geometry.triangles.size(), false);
    for (int b = 0; b < grid.settings.bins; ++b)
        for (uint32_t id : grid.list(view, tile, b)) listed[id] = true;
    std::vector<TileEntry> entries;
    for (uint32_t id = 0; id < geometry.triangles.size(); ++id) {
        bool due = false;
        scanTriangle(
            geometry.triangles[id], grid.views[(size_t) view], [&](int t) { return t == tile; },
            [&](int, DepthInterval depths) {
                due = true;
                entries.push_back(entryOf(grid, geometry, id, view, tile, &depths));
            });
        if (!due && listed[id]) entries.push_back(entryOf(grid, geometry, id, view, tile, nullptr));
    }
    return entries;
}

std::vector<TileEntry> entriesOfPrimitive(const Grid& grid, const FrameGeometry& geometry,
                                          uint32_t id) {
    std::vector<TileEntry> entries;
    for (size_t v = 0; v < grid.views.size(); ++v) {
        const View& view = grid.views[v];
        std::vector<bool> due((size_t) view.tiles(), false);
        const size_t first = entries.size();
        scanTriangle(geometry.triangles[id], view, [&](int tile, DepthInterval depths) {
            due[(size_t) tile] = true;
            entries.push_back(entryOf(grid, geometry, id, (int) v, tile, &depths));
        });
        for (int tile = 0; tile < view.tiles(); ++tile) {
            if (due[(size_t) tile]) continue;
            TileEntry entry = entryOf(grid, geometry, id, (int) v, tile, nullptr);
            if (!entry.bins.empty()) entries.push_back(std::move(entry));
        }
        std::sort(entries.begin() + (std::ptrdiff_t) first, entries.end(),
                  [](const TileEntry& a, const TileEntry& b) {
                      return a.row != b.row ? a.row < b.row : a.column < b.column;
                  });
    }
    return entries;
}

} // namespace dirt
