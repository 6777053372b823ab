#include "core/preview/path_marks.h"

#include "core/explain/explained_ray.h"
#include "core/preview/ray_panels.h"
#include "core/preview/sheet.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace dirt {

namespace {

struct RayKind {
    const char* name;
    Colour colour;
    const char* meaning;
};

constexpr RayKind kRayKinds[] = {
    {"primary", {255, 255, 255}, "the ray from the eye"},
    {"indirect", {86, 180, 233}, "indirect rays"},
    {"shadow", {240, 228, 66}, "shadow rays"},
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
        marks.push_back({Mark::Shape::box, at, at + 1.0, colour, (int) index});
    }
    const double end = std::min(ray.end(), trail.span.end);
    if (end < trail.span.begin) return;
    const auto image = imageOf(view, ray.trail.ray, trail.span.begin, end);
    for (size_t i = 1; i < image.size(); ++i)
        marks.push_back({Mark::Shape::line, corner + image[i - 1] / cell, corner + image[i] / cell,
                         colour, (int) index});
    if (!ray.hits() || end < ray.end()) return;
    const glm::dvec3 origin(ray.trail.ray.origin), direction(ray.trail.ray.direction);
    if (const auto hit = inTiles(view, origin + end * direction))
        marks.push_back({Mark::Shape::cross, corner + *hit / cell, {}, kHitMark, (int) index});
}

/// The same in the image. The eye is the origin of the grid frame.
void markInImage(std::vector<Mark>& marks, const DrawnRay& ray, const ImagePlane& plane,
                 Colour colour) {
    const glm::dvec3 right(plane.right), down(plane.down), forward(plane.forward);
    const glm::dvec3 origin(ray.trail.ray.origin), direction(ray.trail.ray.direction);
    const auto pixel = [&](glm::dvec3 p) {
        const double ahead = glm::dot(p, forward);
        return glm::dvec2((glm::dot(p, right) / ahead - (double) plane.slopeX) / plane.stepX,
                          (glm::dot(p, down) / ahead - (double) plane.slopeY) / plane.stepY);
    };
    // What of the ray is so far before the eye that its image is not far outside.
    const double speed = glm::dot(direction, forward), start = glm::dot(origin, forward);
    const double least = 1e-6 * (std::abs(start) + std::abs(speed));
    double begin = 0.0, end = std::min(ray.end(), 1e9);
    if (speed == 0.0 && start < least) return;
    if (speed > 0.0) begin = std::max(begin, (least - start) / speed);
    if (speed < 0.0) end = std::min(end, (least - start) / speed);
    if (!(begin < end)) return;
    marks.push_back({Mark::Shape::line, pixel(origin + begin * direction),
                     pixel(origin + end * direction), colour});
    if (ray.hits() && end == ray.end())
        marks.push_back({Mark::Shape::cross, pixel(origin + end * direction), {}, kHitMark});
}

/// Calls \p draw(ray, colour) for the rays that are asked for, and says what was drawn.
template <typename Draw>
std::vector<Key> forEachRay(const PathAccount& account, const PathRequest& path, const char* tiles,
                            const Draw& draw) {
    bool drawn[std::size(kRayKinds)] = {};
    for (const EventAccount& event : account.events) {
        if (path.event && *path.event != event.event) continue;
        const std::vector<ExplainedRay> rays = raysOf(account, event);
        for (size_t i = 0; i < rays.size(); ++i) {
            if (path.ray && (size_t) *path.ray != i) continue;
            const auto kind =
                std::find_if(std::begin(kRayKinds), std::end(kRayKinds),
                             [&](const RayKind& known) { return rays[i].kind == known.name; });
            drawn[kind - std::begin(kRayKinds)] = true;
            draw(DrawnRay{*account.grid, account.geometry, *rays[i].trail}, kind->colour);
        }
    }
    std::vector<Key> keys;
    const std::string pixel = "pixel " + textOf(path) + ": ";
    for (size_t i = 0; i < std::size(kRayKinds); ++i)
        if (drawn[i])
            keys.push_back({Key::Shape::box, kBackground, kRayKinds[i].colour,
                            pixel + kRayKinds[i].meaning + tiles});
    keys.push_back(
        {Key::Shape::cross, kHitMark, kHitMark,
         keys.empty() ? pixel + "its path has no ray there" : "where they hit something"});
    return keys;
}

} // namespace

Marks marksOfPath(const PathAccount& account, const PathRequest& path, int level) {
    Marks marks;
    marks.keys = forEachRay(account, path, ", and the tiles that they visit",
                            [&](const DrawnRay& ray, Colour colour) {
                                for (const ViewTrail& view : ray.trail.views)
                                    markRay(marks.marks, ray, view, level, colour);
                            });
    return marks;
}

Marks marksInImage(const PathAccount& account, const PathRequest& path, const CameraRays& camera) {
    Marks marks = marksOfPixel(path);
    marks.keys = forEachRay(account, path, "", [&](const DrawnRay& ray, Colour colour) {
        markInImage(marks.marks, ray, camera.plane(), colour);
    });
    return marks;
}

std::vector<Mark> placeMarks(const std::vector<Mark>& marks, const Grid& grid,
                             const std::vector<PictureValues>& parts) {
    std::vector<Mark> placed;
    for (Mark mark : marks)
        for (const PictureValues& part : parts) {
            if (part.view != mark.view) continue;
            const Sheet sheet(grid, part.level);
            const auto view = (size_t) part.view;
            const glm::dvec2 before(sheet.left(view), sheet.top(view));
            const glm::dvec2 corner(part.pixels.left, part.pixels.top);
            mark.from = corner + (mark.from - before) * (double) part.times;
            mark.to = corner + (mark.to - before) * (double) part.times;
            placed.push_back(mark);
            break;
        }
    return placed;
}

Marks marksOfPixel(const PathRequest& path) {
    const glm::dvec2 corner(path.pixel[0], path.pixel[1]);
    return {{{Mark::Shape::pixel, corner, {}, kWords}},
            {{Key::Shape::box, kBackground, kWords, "pixel " + textOf(path)}}};
}

} // namespace dirt
