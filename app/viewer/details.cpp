#include "app/viewer/details.h"

#include "app/cli/explain_text.h"
#include "core/explain/explained_ray.h"

#include <algorithm>

namespace dirt {

std::vector<PathRequest> stepsOf(const PathAccount& account, std::array<int, 2> pixel) {
    std::vector<PathRequest> steps{{pixel}};
    for (const EventAccount& event : account.events)
        for (int ray = 0; ray < (int) raysOf(account, event).size(); ++ray)
            steps.push_back({pixel, event.event, ray});
    return steps;
}

std::string pathText(const Scene& scene, const PathAccount& account, const PathRequest& shown) {
    std::string text = "pixel (" + std::to_string(shown.pixel[0]) + ", " +
                       std::to_string(shown.pixel[1]) + "), sample " +
                       std::to_string(account.sample) + "\n";
    for (const EventAccount& event : account.events) {
        if (shown.event && *shown.event != event.event) continue;
        if (shown.event) text += eventText(scene, account, event);
        const std::vector<ExplainedRay> rays = raysOf(account, event);
        for (int i = 0; i < (int) rays.size(); ++i) {
            const ExplainedRay& ray = rays[(size_t) i];
            if (shown.ray && *shown.ray != i) continue;
            text += shown.ray ? rayText(account.grid, ray)
                              : "event " + std::to_string(event.event) + ", " + rayLine(ray);
            const std::string problem = disagreement(event, ray);
            if (!problem.empty()) text += "  DIFFERENT: " + problem + "\n";
        }
    }
    return text;
}

std::string tileText(const Scene& scene, const Grid& grid, const FrameGeometry& geometry,
                     std::array<int, 3> tile) {
    const auto [view, column, row] = tile;
    const std::vector<TileEntry> entries = entriesOfTile(grid, geometry, view, column, row);
    const auto wrong = std::count_if(entries.begin(), entries.end(),
                                     [](const TileEntry& entry) { return !entry.isRight(); });
    return tileLine(grid, view, column, row) + "\n" + std::to_string(entries.size()) +
           " entries, " + std::to_string(wrong) + " wrong\n" + entriesText(scene, grid, entries);
}

} // namespace dirt
