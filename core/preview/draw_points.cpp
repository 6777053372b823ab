#include "core/preview/pixel_pictures.h"
#include "core/preview/seen.h"

#include <limits>
#include <string_view>

namespace dirt {

namespace {

const std::vector<SurfacePoint>& pointsOf(const Seen& seen, const PreviewRequest& request) {
    const std::vector<SurfacePoint>& points =
        request.point == PointChoice::previous  ? seen.paths.previous
        : request.point == PointChoice::current ? seen.paths.current
                                                : seen.paths.next;
    if (points.empty()) missing(request, "this frame keeps no such point");
    return points;
}

/// The corners of the box around all points.
std::pair<glm::vec3, glm::vec3> boxOf(const std::vector<SurfacePoint>& points) {
    const float infinity = std::numeric_limits<float>::infinity();
    glm::vec3 low(infinity), high(-infinity);
    for (const SurfacePoint& point : points)
        for (int c = 0; point.found() && c < 3; ++c) {
            low[c] = std::min(low[c], point.position[c]);
            high[c] = std::max(high[c], point.position[c]);
        }
    return {low, high};
}

float reflectanceOf(const SurfacePoint& p) {
    return (float) (p.gloss & 0xffffu) / 65535.0f;
}
float metallicOf(const SurfacePoint& p) {
    return (float) (p.gloss >> 16) / 65535.0f;
}
float radianceOf(const SurfacePoint& p) {
    return (p.emission.x + p.emission.y + p.emission.z) / 3.0f;
}

} // namespace

PreviewPicture drawPoints(const Seen& seen, const GridSettings& grid,
                          const PreviewRequest& request) {
    const std::string_view name = request.kind->name;
    const auto& points = pointsOf(seen, request);
    const auto vectors = [&](glm::vec3 low, glm::vec3 high, const char* scale, auto&& get) {
        return colours(grid, low, high, scale, [&points, get](size_t i) {
            return points[i].found() ? std::optional<glm::vec3>(get(points[i])) : std::nullopt;
        });
    };
    const auto numbers = [&](const char* unit, auto&& get) {
        return heat(grid, unit, true, [&points, get](size_t i) {
            return points[i].found() ? (double) get(points[i]) : std::nan("");
        });
    };
    const glm::vec3 zero(0.0f), one(1.0f);
    const char* const axes = "-1 to 1 an axis, grid frame";
    using Point = const SurfacePoint&;
    if (name == "primitive")
        return ids(grid.width, grid.height, [&](size_t i) { return points[i].primitive; });
    if (name == "barycentrics")
        return vectors(zero, one, "0 to 1: weights of the triangle's corners in R, G, B",
                       [](Point p) { return glm::vec3(1.0f - p.u - p.v, p.u, p.v); });
    if (name == "normal") return vectors(-one, one, axes, [](Point p) { return p.shadingNormal; });
    if (name == "geometric-normal")
        return vectors(-one, one, axes, [](Point p) { return p.geometricNormal; });
    if (name == "diffuse") return vectors(zero, one, "0 to 1", [](Point p) { return p.diffuse; });
    if (name == "position") {
        const auto [low, high] = boxOf(points);
        return vectors(low, high, "from corner to corner of the box around them",
                       [](Point p) { return p.position; });
    }
    if (name == "roughness") return numbers("roughness", [](Point p) { return p.roughness; });
    if (name == "reflectance") return numbers("reflectance", reflectanceOf);
    if (name == "metallic") return numbers("metallic", metallicOf);
    return numbers("mean radiance", radianceOf);
}

} // namespace dirt
