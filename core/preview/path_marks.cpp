#include "core/preview/path_marks.h"

#include "core/explain/explained_ray.h"
#include "core/preview/ray_panels.h"
#include "core/preview/sheet.h"

#include <algorithm>

namespace dirt {

namespace {

struct RayKind {
    const char* name;
    Colour colour;
    const char* meaning;
};

constexpr RayKind kRayKinds[] = {
    {"primary", {255, 255, 255}, "the ray from the eye, and the tiles that it visits"},
    {"indirect", {86, 180, 233}, "indirect rays, likewise"},
    {"shadow", {240, 228, 66}, "shadow rays, likewise"},
};

std::string textOf(const PathRequest& path) {
    return "(" + std::to_string(path.pixel[0]) + ", " + std::to_string(path.pixel[1]) + ")";
}

/// The marks of one ray in one view.
void markRay(std::vector<Mark>& marks, const DrawnRay& ray, const ViewTrail& trail, int level,
             Colour colour) {
    const size_t index = (size_t) trail.span.view;
    const View& view = ray.grid.views[index];
    const Sheet sheet(ray.grid, level);
    const glm::dvec2 corner(sheet.left(index), sheet.top(index));
    const double cell = (double) (1 << level);
    for (const TileTrail& tile : trail.tiles) {
        const glm::dvec2 at = corner + glm::dvec2(tile.column >> level, tile.row >> level);
        marks.push_back({Mark::Shape::box, at, at + 1.0, colour});
    }
    const double end = std::min(ray.end(), trail.span.end);
    if (end < trail.span.begin) return;
    const auto image = imageOf(view, ray.trail.ray, trail.span.begin, end);
    for (size_t i = 1; i < image.size(); ++i)
        marks.push_back(
            {Mark::Shape::line, corner + image[i - 1] / cell, corner + image[i] / cell, colour});
    if (!ray.hits() || end < ray.end()) return;
    const glm::dvec3 origin(ray.trail.ray.origin), direction(ray.trail.ray.direction);
    if (const auto hit = inTiles(view, origin + end * direction))
        marks.push_back({Mark::Shape::cross, corner + *hit / cell, {}, kHitMark});
}

} // namespace

Marks marksOfPath(const PathAccount& account, const PathRequest& path, int level) {
    Marks marks;
    bool drawn[std::size(kRayKinds)] = {};
    for (const EventAccount& event : account.events) {
        if (path.event && *path.event != event.event) continue;
        for (const ExplainedRay& ray : raysOf(account, event)) {
            const auto kind =
                std::find_if(std::begin(kRayKinds), std::end(kRayKinds),
                             [&](const RayKind& known) { return ray.kind == known.name; });
            drawn[kind - std::begin(kRayKinds)] = true;
            const DrawnRay one{*account.grid, account.geometry, *ray.trail};
            for (const ViewTrail& view : ray.trail->views)
                markRay(marks.marks, one, view, level, kind->colour);
        }
    }
    for (size_t i = 0; i < std::size(kRayKinds); ++i)
        if (drawn[i])
            marks.keys.push_back({Key::Shape::box, kBackground, kRayKinds[i].colour,
                                  "pixel " + textOf(path) + ": " + kRayKinds[i].meaning});
    marks.keys.push_back({Key::Shape::cross, kHitMark, kHitMark,
                          marks.keys.empty()
                              ? "pixel " + textOf(path) + ": its path has no ray there"
                              : "where they hit something"});
    return marks;
}

Marks marksOfPixel(const PathRequest& path) {
    const glm::dvec2 corner(path.pixel[0], path.pixel[1]);
    return {{{Mark::Shape::pixel, corner, {}, kWords}},
            {{Key::Shape::box, kBackground, kWords, "pixel " + textOf(path)}}};
}

} // namespace dirt
