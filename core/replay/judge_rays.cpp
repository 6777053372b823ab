#include "core/replay/judge_rays.h"

#include "core/replay/dumped_view.h"

#include <algorithm>
#include <cstdio>

namespace dirt {

ViewScope scopeOf(const Manifest& manifest) {
    if (manifest.settings.mode == ViewMode::full) return ViewScope(std::nullopt);
    if (!manifest.views.empty()) return ViewScope(manifest.views.front());
    return ViewScope(makeViews(manifest.settings, dumpedCamera(manifest.fov)).front());
}

bool isListed(const ReplayInput& input, const Hit& hit) {
    const Grid& grid = *input.grid;
    if (hit.view == grid.views.size())
        return std::binary_search(grid.atEye.begin(), grid.atEye.end(), hit.primitive);
    for (int bin = 0; bin < grid.settings.bins; ++bin) {
        const auto list = grid.list((int) hit.view, (int) hit.tile, bin);
        if (std::binary_search(list.begin(), list.end(), hit.primitive)) return true;
    }
    return false;
}

std::string misfiledText(const ReplayInput& input, const Hit& hit) {
    const Grid& grid = *input.grid;
    if (hit.view == grid.views.size()) return "filed at the eye, which it does not hold";
    const auto columns = (uint32_t) grid.views[hit.view].columns;
    return "filed in view " + input.manifest.viewNames[hit.view] + ", column " +
           std::to_string(hit.tile % columns) + ", row " + std::to_string(hit.tile / columns) +
           ", which does not list it";
}

std::string pixelText(const ReplayInput& input, uint32_t pixel) {
    const auto width = (uint32_t) input.manifest.settings.width;
    return "pixel " + std::to_string(pixel % width) + "," + std::to_string(pixel / width);
}

std::string numberText(double x) {
    char text[40];
    std::snprintf(text, sizeof text, "%.9g", x);
    return text;
}

} // namespace dirt
