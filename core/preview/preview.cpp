#include "core/preview/preview.h"

#include "core/base/error.h"
#include "core/explain/path_account.h"
#include "core/frame/passes.h"
#include "core/frame/renderer.h"
#include "core/path/tone_mapping.h"
#include "core/preview/overview.h"
#include "core/preview/paint.h"
#include "core/preview/path_marks.h"
#include "core/preview/seen.h"

#include <string_view>

namespace dirt {

namespace {

using Of = PreviewKind::Of;

constexpr PreviewKind kKinds[] = {
    {"image", "what render gives", Of::image},
    {"overview", "the image, and around it the views with their --buffer", Of::overview},
    {"near", "nearest depth of what a tile lists, or a cell of --level", Of::views},
    {"far", "farthest depth of the same", Of::views},
    {"entries", "how many ids a tile lists, or its --bin", Of::views},
    {"first", "the first primitive that a tile lists", Of::views},
    {"cells", "cells of the pyramid that each pixel's ray looks at", Of::event},
    {"tiles", "tiles that it visits", Of::event},
    {"bins", "bins that it visits", Of::event},
    {"tests", "triangles that it tests", Of::event},
    {"time", "nanoseconds of its walk by the definition, never the same twice", Of::event},
    {"hits", "the primitive that it hits", Of::event},
    {"distance", "how far from its origin", Of::event},
    {"mask", "pixels whose path goes on", Of::event},
    {"visibility", "points that the light reaches", Of::event},
    {"primitive", "the primitive that the surface point lies on", Of::point},
    {"barycentrics", "where on it", Of::point},
    {"position", "where the surface point lies, scaled to the scene's box", Of::point},
    {"normal", "its shading normal; 0 is grey", Of::point},
    {"geometric-normal", "its triangle's normal", Of::point},
    {"diffuse", "its colour", Of::point},
    {"emission", "the radiance it emits", Of::point},
    {"roughness", "of its microfacets", Of::point},
    {"reflectance", "of its microfacets at normal incidence", Of::point},
    {"metallic", "how far it is a metal", Of::point},
    {"shadowmap", "depths that the light sees", Of::light},
};

/// A preview in the making.
class Preview {
public:
    Preview(const Scene& scene, const RenderSettings& settings, Backend& backend,
            const PreviewRequest& request, const std::function<bool()>& stop)
        : scene_(scene), settings_(settings), backend_(backend), request_(request), stop_(stop) {}

    PreviewPicture draw() {
        switch (request_.kind->of) {
        case Of::image:
            return markPixel(drawImage());
        case Of::views:
            return drawViews(request_);
        case Of::overview:
            return drawAround();
        default:
            return markPixel(drawEvent());
        }
    }

private:
    bool stopped() const { return stop_ && stop_(); }

    PreviewPicture drawImage() {
        RenderHooks hooks;
        hooks.stop = stop_;
        const Image image = Renderer(scene_, settings_, backend_).render(hooks).image;
        PreviewPicture picture = blank(image.width, image.height);
        picture.rgb = DisplayEncoding(scene_.toneMapping).bytes(image.pixels);
        picture.scale = "tone-mapped";
        picture.values.push_back(valuesOf(image));
        picture.bare = true;
        return picture;
    }

    PreviewPicture markPixel(PreviewPicture picture) const {
        if (request_.path) picture.marks = marksOfPixel(*request_.path);
        return picture;
    }

    /// Of the grid, which a path is traced in if one is asked for.
    PreviewPicture drawViews(const PreviewRequest& request) {
        if (!backend_.hasGrid()) missing(request_, "this backend's structure is no grid");
        if (!request.path) {
            backend_.build(scene_.mesh, scene_.camera, settings_.grid);
            grid_ = backend_.readGrid();
            return drawTiles(*grid_, request);
        }
        const auto [x, y] = request.path->pixel;
        const size_t pixel = (size_t) y * (size_t) settings_.grid.width + (size_t) x;
        PathAccount account = accountOf(scene_, settings_, backend_, pixel, request.sample, stop_);
        if (!account.grid) return {}; // it was stopped
        PreviewPicture picture = drawTiles(*account.grid, request);
        picture.marks = marksOfPath(account, *request.path, request.level);
        grid_ = std::move(account.grid);
        return picture;
    }

    PreviewPicture drawAround() {
        PreviewRequest views = request_;
        views.kind = request_.around;
        const PreviewPicture sheet = drawViews(views);
        if (stopped() || !grid_) return {};
        PreviewPicture image = markPixel(drawImage());
        if (stopped()) return {};
        image.marks.keys.clear(); // those of the views say which pixel it is
        return drawOverview(image, sheet, *grid_, scene_.camera, request_.level);
    }

    PreviewPicture drawEvent() {
        if (request_.event >= settings_.bounces)
            missing(request_, "the path events of " + std::to_string(settings_.bounces) +
                                  " bounces are 0 to " + std::to_string(settings_.bounces - 1));
        const Seen seen = look();
        if (seen.rays.empty()) return {}; // it was stopped
        if (request_.kind->of == Of::light) return drawShadowMap(seen, request_);
        if (request_.kind->of == Of::point) return drawPoints(seen, settings_.grid, request_);
        return drawPixels(seen, settings_.grid, request_);
    }

    /// Renders the sample and looks at its event.
    Seen look() {
        RenderSettings one = settings_;
        one.samples = 1;
        const Requirements need = requirementsOf(scene_, one, backend_.rasterizes());
        Seen seen;
        RenderHooks hooks;
        hooks.stop = stop_;
        hooks.observe = [&](uint32_t, int event) {
            if (event != request_.event) return;
            seen.geometry = backend_.readGeometry();
            seen.geometry.cutOuts = need.cutOuts ? &scene_ : nullptr;
            if (backend_.hasGrid()) seen.grid = backend_.readGrid();
            seen.paths = backend_.readPaths();
            seen.shadowMap = backend_.readShadowMap();
            seen.rays = seen.paths.rays;
            if (event > 0 || need.tracedPrimary) return;
            const FrameContext frame(scene_, seen.geometry, one, need);
            seen.rays.resize(seen.paths.pixels());
            for (size_t i = 0; i < seen.rays.size(); ++i)
                seen.rays[i] = primaryRay(frame, i, request_.sample);
        };
        Renderer renderer(scene_, one, backend_);
        renderer.beginAt(request_.sample);
        if (request_.point != PointChoice::next) renderer.keepPreviousPoint();
        renderer.render(hooks);
        return seen;
    }

    const Scene& scene_;
    const RenderSettings& settings_;
    Backend& backend_;
    const PreviewRequest& request_;
    const std::function<bool()>& stop_;
    std::optional<Grid> grid_; ///< that the views were drawn of
};

} // namespace

std::span<const PreviewKind> previewKinds() {
    return kKinds;
}

const PreviewKind* previewKind(std::string_view name) {
    for (const PreviewKind& kind : kKinds)
        if (name == kind.name) return &kind;
    return nullptr;
}

PreviewPicture drawPreview(const Scene& scene, const RenderSettings& settings, Backend& backend,
                           const PreviewRequest& request, const std::function<bool()>& stop) {
    return Preview(scene, settings, backend, request, stop).draw();
}

} // namespace dirt
