#include "core/base/error.h"
#include "core/preview/pixel_pictures.h"
#include "core/preview/seen.h"
#include "core/trace/traverse.h"

#include <chrono>
#include <string_view>

namespace dirt {

namespace {

/// The least of a few walks: what else the machine does makes single ones longer.
double nanosecondsOf(const Seen& seen, const Ray& ray) {
    using Clock = std::chrono::steady_clock;
    double least = INFINITY;
    for (int i = 0; i < 3; ++i) {
        const auto start = Clock::now();
        closestHit(*seen.grid, seen.geometry, ray);
        const std::chrono::duration<double, std::nano> time = Clock::now() - start;
        least = std::min(least, time.count());
    }
    return least;
}

double workOf(const Seen& seen, const Ray& ray, std::string_view name) {
    if (name == "time") return nanosecondsOf(seen, ray);
    TraversalCounts counts;
    closestHit(*seen.grid, seen.geometry, ray, &counts);
    return (double) (name == "cells"   ? counts.steps
                     : name == "tiles" ? counts.tiles
                     : name == "bins"  ? counts.bins
                                       : counts.tests);
}

/// How much work the definition has with each pixel's ray in the backend's grid.
PreviewPicture drawWork(const Seen& seen, const GridSettings& grid, const PreviewRequest& request) {
    if (!seen.grid) missing(request, "this backend's structure is no grid");
    const std::string name = request.kind->name;
    return heat(grid, (name == "time" ? "nanoseconds" : name) + " a ray", true, [&](size_t i) {
        const PathRay& ray = seen.rays[i];
        if (ray.direction == glm::vec3(0.0f)) return std::nan("");
        return workOf(seen, {ray.origin, ray.direction, ray.skip}, name);
    });
}

PreviewPicture drawFlags(const Seen& seen, const GridSettings& grid,
                         const PreviewRequest& request) {
    const bool mask = std::string_view(request.kind->name) == "mask";
    const std::vector<uint8_t>& flags = mask ? seen.paths.mask : seen.paths.visibility;
    if (flags.empty()) missing(request, "this frame has none");
    return colours(grid, glm::vec3(0.0f), glm::vec3(1.0f), "black: no, white: yes",
                   [&](size_t i) { return std::optional(glm::vec3((float) (flags[i] != 0))); });
}

PreviewPicture drawDistance(const Seen& seen, const GridSettings& grid) {
    return heat(grid, "in the grid frame", false, [&](size_t i) {
        const SurfacePoint& point = seen.paths.next[i];
        if (!point.found()) return std::nan("");
        const glm::dvec3 way = glm::dvec3(point.position) - glm::dvec3(seen.rays[i].origin);
        return std::sqrt(way.x * way.x + way.y * way.y + way.z * way.z);
    });
}

} // namespace

void missing(const PreviewRequest& request, const std::string& why) {
    throw InputError(std::string("--show ") + request.kind->name + ": " + why);
}

PreviewPicture drawPixels(const Seen& seen, const GridSettings& grid,
                          const PreviewRequest& request) {
    const std::string_view name = request.kind->name;
    if (name == "mask" || name == "visibility") return drawFlags(seen, grid, request);
    if (name == "hits")
        return ids(grid.width, grid.height, [&](size_t i) { return seen.paths.next[i].primitive; });
    if (name == "distance") return drawDistance(seen, grid);
    return drawWork(seen, grid, request);
}

PreviewPicture drawShadowMap(const Seen& seen, const PreviewRequest& request) {
    const std::vector<float>& depths = seen.shadowMap;
    if (depths.empty()) missing(request, "this frame has none (--visibility shadowmap)");
    const int side = (int) std::lround(std::sqrt((double) depths.size()));
    HeatMap map(side, side, "of depth from the light");
    for (size_t i = 0; i < depths.size(); ++i)
        if (depths[i] < 3e38f) map.values[i] = (double) depths[i]; // else nothing casts there
    return map.paint(false);
}

} // namespace dirt
