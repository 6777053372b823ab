#include "core/frame/renderer.h"

#include "core/frame/pass_clock.h"
#include "core/frame/passes.h"

#include <algorithm>
#include <chrono>

namespace dirt {

namespace {

/// One frame in the making.
class Frame {
public:
    Frame(const FrameContext& context, const RenderHooks& hooks, PassClock& clock,
          RenderResult& result)
        : context_(context), hooks_(hooks), clock_(clock), result_(result) {}

    /// The order of the passes of one sample. False if it was given up.
    bool sample(uint32_t index) {
        clock_.time("Rays", 0, [&] { passRays(context_, index, paths_); });
        if (!event(index, 0)) return false;
        for (int k = 1; k < context_.settings.bounces; ++k) {
            clock_.time("DepthMask", k, [&] { passDepthMask(context_, index, k, paths_); });
            if (!event(index, k)) return false;
        }
        return true;
    }

    /// Adds the finished sample to \p sum.
    void accumulate(std::vector<glm::vec3>& sum) {
        clock_.time("Resolve", 0, [&] {
            context_.executor.forRange(sum.size(), 4096, [&](size_t begin, size_t end) {
                for (size_t i = begin; i < end; ++i) sum[i] += paths_.radiance[i];
            });
        });
    }

    size_t bytes() const { return paths_.bytes(); }

private:
    bool stopped() const { return hooks_.stop && hooks_.stop(); }

    bool event(uint32_t sample, int k) {
        if (stopped()) return false;
        clock_.time("Trace", k, [&] { passTrace(context_, k, paths_); });
        countRays();
        if (hooks_.observe) hooks_.observe({sample, k, paths_.pixels, paths_.rays, paths_.hits});
        clock_.time("Fetch", k, [&] { passFetch(context_, paths_); });
        if (stopped()) return false;
        clock_.time("Visibility", k, [&] { passVisibility(context_, paths_); });
        clock_.time("Shade", k, [&] { passShade(context_, k, paths_); });
        result_.shadowRays += paths_.shadowPaths.size();
        return !stopped();
    }

    void countRays() {
        result_.rays += paths_.rays.size();
        for (const Hit& hit : paths_.hits) result_.hits += hit.found() ? 1 : 0;
    }

    const FrameContext& context_;
    const RenderHooks& hooks_;
    PassClock& clock_;
    RenderResult& result_;
    PathBuffers paths_;
};

} // namespace

double RenderResult::passMs(const char* name) const {
    double sum = 0.0;
    for (const PassTime& pass : passes)
        if (pass.name == name) sum += pass.ms;
    return sum;
}

Renderer::Renderer(const Scene& scene, const RenderSettings& settings, Backend& backend,
                   Executor& executor)
    : scene_(scene), settings_(settings), backend_(backend), executor_(executor) {}

RenderResult Renderer::render(const RenderHooks& hooks) {
    const auto start = std::chrono::steady_clock::now();
    const GridSettings& grid = settings_.grid;
    RenderResult result;
    PassClock clock;

    const FrameGeometry geometry = makeFrameGeometry(scene_.mesh, scene_.camera, grid.mode);
    backend_.build(geometry, scene_.camera, grid);
    result.passes = backend_.buildPasses();

    FrameContext context{.scene = scene_,
                         .geometry = geometry,
                         .settings = settings_,
                         .backend = backend_,
                         .executor = executor_,
                         .camera = {scene_.camera, grid.width, grid.height, grid.mode},
                         .light = {},
                         .view = {}};
    if (grid.mode == ViewMode::single) context.view.emplace(makeViews(grid, scene_.camera).front());
    if (!scene_.lights.empty()) context.light.emplace(scene_.lights.front(), geometry.frame);

    result.image = {grid.width, grid.height,
                    std::vector<glm::vec3>((size_t) grid.width * grid.height, glm::vec3(0.0f))};
    Frame frame(context, hooks, clock, result);
    while (result.samples < settings_.samples && frame.sample((uint32_t) result.samples)) {
        frame.accumulate(result.image.pixels);
        ++result.samples;
        if (hooks.progress) hooks.progress(result.samples, settings_.samples);
    }
    if (result.samples > 0) {
        const float weight = 1.0f / (float) result.samples;
        for (glm::vec3& pixel : result.image.pixels) pixel *= weight;
    }

    result.passes.insert(result.passes.end(), clock.times().begin(), clock.times().end());
    result.shadingBytes = frame.bytes();
    result.frameMs =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    return result;
}

} // namespace dirt
