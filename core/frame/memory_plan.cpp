#include "core/frame/memory_plan.h"

#include "core/frame/path_buffers.h"
#include "core/grid/grid.h"

namespace dirt {

namespace {

std::string number(uint64_t n) {
    return std::to_string(n);
}

} // namespace

std::vector<PlannedBuffer> planStructure(const GridSettings& settings, const Camera& camera,
                                         uint64_t triangles, uint64_t listEntries) {
    uint64_t tiles = 0, coarser = 0;
    const std::vector<View> views = makeViews(settings, camera);
    for (const View& view : views) {
        tiles += (uint64_t) view.tiles();
        for (int columns = view.columns, rows = view.rows; columns > 1 || rows > 1;) {
            columns = (columns + 1) / 2;
            rows = (rows + 1) / 2;
            coarser += (uint64_t) columns * (uint64_t) rows;
        }
    }
    const std::string tilesText = number(tiles) + " tiles of " + number(views.size()) +
                                  (views.size() == 1 ? " view" : " views");
    return {
        {"triangle buffer", triangles * sizeof(Triangle),
         "the frame's geometry: " + number(triangles) + " triangles"},
        {"depth bounds", tiles * sizeof(DepthBounds), "near and far of " + tilesText},
        {"depth pyramid", coarser * sizeof(DepthBounds), "to step over empty tiles"},
        {"id buffer heads", (tiles * (uint64_t) settings.bins + 1) * sizeof(uint32_t),
         "where each list begins: " + number((uint64_t) settings.bins) + " bins of " + tilesText},
        {"id buffer", listEntries * sizeof(uint32_t),
         number(listEntries) + " list entries, counted in the build"},
    };
}

std::vector<PlannedBuffer> planPaths(const Requirements& need, const GridSettings& settings) {
    const uint64_t pixels = (uint64_t) settings.width * (uint64_t) settings.height;
    std::vector<PlannedBuffer> plan;
    const auto add = [&](const char* name, bool wanted, size_t record, const char* reason) {
        if (wanted) plan.push_back({name, pixels * record, reason});
    };
    const bool rays = need.indirect || need.tracedPrimary;
    const size_t point = pointFormatOf(need).bytes();
    add("shading buffer G[k-1]", need.previousPoint, point, "asked for");
    add("shading buffer G[k]", need.indirect || need.previousPoint, point,
        "where indirect rays start");
    add("shading buffer G[k+1]", true, point, "what the rays have found");
    add("mask", need.indirect, sizeof(uint8_t), "paths that go on");
    add("rays", rays, sizeof(PathRay), need.indirect ? "indirect rays" : "traced primary rays");
    add("hit buffer", rays, sizeof(Hit), "at most one hit a pixel");
    add("visibility", need.shadowRays, sizeof(uint8_t), "shadow rays to the light");
    add("radiance", true, sizeof(glm::vec3), "of the sample under way");
    add("image", true, sizeof(glm::vec3), "sum of the finished samples");
    if (need.shadowMap > 0)
        plan.push_back({"shadow map", uint64_t(need.shadowMap) * need.shadowMap * sizeof(float),
                        "nearest depths as the light sees them"});
    return plan;
}

} // namespace dirt
