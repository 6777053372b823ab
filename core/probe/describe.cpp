#include "core/probe/grid_probe.h"

#include <sstream>

namespace dirt {

std::string GridProbe::viewName(int view) const {
    if (grid_.settings.mode == ViewMode::single) return "camera";
    const View& face = grid_.views[view];
    return std::string(face.signW > 0.0f ? "+" : "-") + "XYZ"[face.axisW];
}

std::string GridProbe::describe(const Tile& tile) const {
    std::ostringstream text;
    const WorldDepths range = depths(tile);
    text << tile << " (" << viewName(tile.view) << "): ";
    if (range.empty()) {
        text << "empty\n";
        return text.str();
    }
    text << "depth " << range.near << " to " << range.far << "\n";
    const int bins = grid_.settings.bins;
    const float length = (range.far - range.near) / (float) bins;
    for (int bin = 0; bin < bins; ++bin) {
        text << "  bin " << bin << " from " << range.near + (float) bin * length << ":";
        const Ids listed = ids(Cell{tile.view, tile.column, tile.row, bin});
        for (uint32_t id : listed) text << " " << id;
        text << (listed.empty() ? " -\n" : "\n");
    }
    return text.str();
}

std::string GridProbe::describe() const {
    std::ostringstream text;
    text << geometry_.triangles.size() << " triangles, " << grid_.views.size() << " views of "
         << grid_.views[0].columns << "x" << grid_.views[0].rows << " tiles, "
         << grid_.settings.bins << " bins\n";
    for (size_t v = 0; v < grid_.views.size(); ++v)
        for (int row = 0; row < grid_.views[v].rows; ++row)
            for (int column = 0; column < grid_.views[v].columns; ++column) {
                const Tile tile{(int) v, column, row};
                if (!depths(tile).empty()) text << describe(tile);
            }
    return text.str();
}

} // namespace dirt
