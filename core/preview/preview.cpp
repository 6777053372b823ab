#include "core/preview/preview.h"

#include "core/base/error.h"
#include "core/frame/passes.h"
#include "core/frame/renderer.h"
#include "core/path/tone_mapping.h"
#include "core/preview/paint.h"
#include "core/trace/traverse.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace dirt {

namespace {

constexpr PreviewKind kKinds[] = {
    {"image", "what render gives", false, false},
    {"near", "nearest depth of what a tile lists, or a cell of --level", true, false},
    {"far", "farthest depth of the same", true, false},
    {"entries", "how many ids a tile lists, or its --bin", true, false},
    {"first", "the first primitive that a tile lists", true, false},
    {"cells", "cells of the pyramid that each pixel's ray looks at", false, true},
    {"tiles", "tiles that it visits", false, true},
    {"bins", "bins that it visits", false, true},
    {"tests", "triangles that it tests", false, true},
    {"hits", "the primitive that it hits", false, true},
    {"distance", "how far from its origin", false, true},
    {"mask", "pixels whose path goes on", false, true},
    {"visibility", "points that the light reaches", false, true},
    {"position", "where the surface point lies, scaled to the scene's box", false, true},
    {"normal", "its shading normal; 0 is grey", false, true},
    {"geometric-normal", "its triangle's normal", false, true},
    {"diffuse", "its colour", false, true},
    {"emission", "the radiance it emits", false, true},
    {"roughness", "of its microfacets", false, true},
    {"reflectance", "of its microfacets at normal incidence", false, true},
    {"metallic", "how far it is a metal", false, true},
    {"shadowmap", "depths that the light sees", false, false},
};

/// What a sample has left behind at the event that is asked for.
struct Seen {
    FrameGeometry geometry;
    std::optional<Grid> grid;
    PathBuffers paths;
    std::vector<float> shadowMap;
    std::vector<PathRay> rays; ///< of the event, whether they were traced or not
};

[[noreturn]] void missing(const PreviewRequest& request, const std::string& why) {
    throw InputError(std::string("--show ") + request.kind->name + ": " + why);
}

/// The picture of a number for each pixel; NaN where there is none.
template <typename Value>
PreviewPicture heat(const GridSettings& grid, const std::string& unit, bool fromZero,
                    const Value& valueOf) {
    HeatMap map(grid.width, grid.height, unit);
    for (size_t i = 0; i < map.values.size(); ++i) map.values[i] = valueOf(i);
    return map.paint(fromZero);
}

/// The picture of a vector for each pixel, from \p low to \p high.
template <typename Value>
PreviewPicture colours(const GridSettings& grid, glm::vec3 low, glm::vec3 high,
                       const std::string& scale, const Value& valueOf) {
    PreviewPicture picture = blank(grid.width, grid.height);
    picture.scale = scale;
    for (int y = 0; y < grid.height; ++y)
        for (int x = 0; x < grid.width; ++x) {
            const std::optional<glm::vec3> value =
                valueOf((size_t) y * (size_t) grid.width + (size_t) x);
            if (!value) continue;
            glm::u8vec3 colour;
            for (int c = 0; c < 3; ++c) {
                const float range = high[c] - low[c];
                const float part = range > 0.0f ? ((*value)[c] - low[c]) / range : 0.0f;
                colour[c] = (uint8_t) std::lround(255.0f * std::clamp(part, 0.0f, 1.0f));
            }
            put(picture, x, y, colour);
        }
    return picture;
}

/// How much work the definition has with each pixel's ray in the backend's grid.
PreviewPicture drawWork(const Seen& seen, const GridSettings& grid, const PreviewRequest& request) {
    if (!seen.grid) missing(request, "this backend's structure is no grid");
    const std::string_view name = request.kind->name;
    return heat(grid, std::string(name) + " a ray", true, [&](size_t i) {
        const PathRay& ray = seen.rays[i];
        if (ray.direction == glm::vec3(0.0f)) return std::nan("");
        TraversalCounts counts;
        closestHit(*seen.grid, seen.geometry, {ray.origin, ray.direction, ray.skip}, &counts);
        return (double) (name == "cells"   ? counts.steps
                         : name == "tiles" ? counts.tiles
                         : name == "bins"  ? counts.bins
                                           : counts.tests);
    });
}

PreviewPicture drawPoints(const Seen& seen, const GridSettings& grid, std::string_view name) {
    const auto& points = seen.paths.next;
    using Part = std::optional<glm::vec3>;
    const auto part = [&](auto&& get) {
        return
            [&points, get](size_t i) { return points[i].found() ? Part(get(points[i])) : Part(); };
    };
    const glm::vec3 one(1.0f);
    if (name == "normal")
        return colours(grid, -one, one, "-1 to 1 an axis, grid frame",
                       part([](const SurfacePoint& p) { return p.shadingNormal; }));
    if (name == "geometric-normal")
        return colours(grid, -one, one, "-1 to 1 an axis, grid frame",
                       part([](const SurfacePoint& p) { return p.geometricNormal; }));
    if (name == "diffuse")
        return colours(grid, glm::vec3(0.0f), one, "0 to 1",
                       part([](const SurfacePoint& p) { return p.diffuse; }));
    if (name == "position") {
        glm::vec3 low(INFINITY), high(-INFINITY);
        for (const SurfacePoint& point : points)
            for (int c = 0; point.found() && c < 3; ++c) {
                low[c] = std::min(low[c], point.position[c]);
                high[c] = std::max(high[c], point.position[c]);
            }
        return colours(grid, low, high, "from corner to corner of the box around them",
                       part([](const SurfacePoint& p) { return p.position; }));
    }
    const auto number = [&](const char* unit, auto&& get) {
        return heat(grid, unit, true, [&points, get](size_t i) {
            return points[i].found() ? (double) get(points[i]) : std::nan("");
        });
    };
    if (name == "roughness") return number("", [](const SurfacePoint& p) { return p.roughness; });
    if (name == "reflectance")
        return number("",
                      [](const SurfacePoint& p) { return (float) (p.gloss & 0xffffu) / 65535.0f; });
    if (name == "metallic")
        return number("", [](const SurfacePoint& p) { return (float) (p.gloss >> 16) / 65535.0f; });
    return number("mean radiance", [](const SurfacePoint& p) {
        return (p.emission.x + p.emission.y + p.emission.z) / 3.0f;
    });
}

PreviewPicture drawShadowMap(const std::vector<float>& depths) {
    const int side = (int) std::lround(std::sqrt((double) depths.size()));
    HeatMap map(side, side, "of depth from the light");
    for (size_t i = 0; i < depths.size(); ++i)
        if (depths[i] < 3e38f) map.values[i] = (double) depths[i]; // else nothing casts there
    return map.paint(false);
}

PreviewPicture drawPixels(const Seen& seen, const GridSettings& grid,
                          const PreviewRequest& request) {
    const std::string_view name = request.kind->name;
    if (name == "cells" || name == "tiles" || name == "bins" || name == "tests")
        return drawWork(seen, grid, request);
    const PathBuffers& paths = seen.paths;
    if (name == "mask" || name == "visibility") {
        const std::vector<uint8_t>& flags = name == "mask" ? paths.mask : paths.visibility;
        if (flags.empty()) missing(request, "this frame has none");
        return colours(grid, glm::vec3(0.0f), glm::vec3(1.0f), "black: no, white: yes",
                       [&](size_t i) { return std::optional(glm::vec3((float) (flags[i] != 0))); });
    }
    if (name == "hits") {
        PreviewPicture picture = blank(grid.width, grid.height);
        picture.scale = "a colour for each primitive";
        for (int y = 0; y < grid.height; ++y)
            for (int x = 0; x < grid.width; ++x)
                put(picture, x, y,
                    idColour(paths.next[(size_t) y * (size_t) grid.width + (size_t) x].primitive));
        return picture;
    }
    if (name == "distance")
        return heat(grid, "in the grid frame", false, [&](size_t i) {
            if (!paths.next[i].found()) return std::nan("");
            const glm::dvec3 way =
                glm::dvec3(paths.next[i].position) - glm::dvec3(seen.rays[i].origin);
            return std::sqrt(way.x * way.x + way.y * way.y + way.z * way.z);
        });
    return drawPoints(seen, grid, name);
}

PreviewPicture drawImage(const Scene& scene, const RenderSettings& settings, Backend& backend,
                         const RenderHooks& hooks) {
    const Image image = Renderer(scene, settings, backend).render(hooks).image;
    return {image.width, image.height, DisplayEncoding(scene.toneMapping).bytes(image.pixels),
            "tone-mapped"};
}

} // namespace

std::span<const PreviewKind> previewKinds() {
    return kKinds;
}

PreviewPicture drawPreview(const Scene& scene, const RenderSettings& settings, Backend& backend,
                           const PreviewRequest& request, const std::function<bool()>& stop) {
    const std::string_view name = request.kind->name;
    RenderHooks hooks;
    hooks.stop = stop;
    if (name == "image") return drawImage(scene, settings, backend, hooks);
    if (request.kind->perView) {
        if (!backend.hasGrid()) missing(request, "this backend's structure is no grid");
        backend.build(scene.mesh, scene.camera, settings.grid);
        return drawTiles(backend.readGrid(), request);
    }
    if (request.event >= settings.bounces)
        missing(request, "the path events of " + std::to_string(settings.bounces) +
                             " bounces are 0 to " + std::to_string(settings.bounces - 1));
    RenderSettings one = settings;
    one.samples = 1;
    const Requirements need = requirementsOf(scene, one, backend.rasterizes());
    Seen seen;
    hooks.observe = [&](uint32_t, int event) {
        if (event != request.event) return;
        seen.geometry = backend.readGeometry();
        seen.geometry.cutOuts = need.cutOuts ? &scene : nullptr;
        if (backend.hasGrid()) seen.grid = backend.readGrid();
        seen.paths = backend.readPaths();
        seen.shadowMap = backend.readShadowMap();
        seen.rays = seen.paths.rays;
        if (event > 0 || need.tracedPrimary) return;
        const FrameContext frame(scene, seen.geometry, one, need);
        seen.rays.resize(seen.paths.pixels());
        for (size_t i = 0; i < seen.rays.size(); ++i)
            seen.rays[i] = primaryRay(frame, i, request.sample);
    };
    Renderer renderer(scene, one, backend);
    renderer.beginAt(request.sample);
    renderer.render(hooks);
    if (seen.rays.empty()) return {}; // it was stopped
    if (name == "shadowmap") {
        if (seen.shadowMap.empty())
            missing(request, "this frame has none (--visibility shadowmap)");
        return drawShadowMap(seen.shadowMap);
    }
    return drawPixels(seen, settings.grid, request);
}

} // namespace dirt
