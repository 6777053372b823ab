#include "core/dump/entries.h"

#include "core/grid/scan.h"

#include <algorithm>
#include <cfloat>
#include <tuple>

namespace dirt {

std::vector<std::vector<ListEntry>> listEntriesOf(const Grid& grid, const FrameGeometry& geometry,
                                                  int view) {
    const size_t tiles = (size_t) grid.views[view].tiles();
    std::vector<std::vector<ListEntry>> entries(tiles);
    for (size_t tile = 0; tile < tiles; ++tile) {
        for (int bin = 0; bin < grid.settings.bins; ++bin)
            for (uint32_t id : grid.list(view, (int) tile, bin))
                entries[tile].push_back({id, (uint32_t) bin, (uint32_t) view, FLT_MAX, -FLT_MAX});
        std::sort(entries[tile].begin(), entries[tile].end(),
                  [](const ListEntry& a, const ListEntry& b) { return a.id < b.id; });
    }

    for (uint32_t id = 0; id < geometry.triangles.size(); ++id)
        scanTriangle(geometry.triangles[id], grid.views[view], [&](int tile, DepthInterval depths) {
            auto& list = entries[tile];
            auto entry =
                std::lower_bound(list.begin(), list.end(), id,
                                 [](const ListEntry& e, uint32_t wanted) { return e.id < wanted; });
            for (; entry != list.end() && entry->id == id; ++entry)
                std::tie(entry->near, entry->far) = std::tie(depths.near, depths.far);
        });

    for (auto& list : entries)
        std::sort(list.begin(), list.end(), [](const ListEntry& a, const ListEntry& b) {
            return std::tie(a.bin, a.near, a.id) < std::tie(b.bin, b.near, b.id);
        });
    return entries;
}

} // namespace dirt
