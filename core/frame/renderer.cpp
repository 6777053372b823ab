#include "core/frame/renderer.h"

#include "core/frame/pass_clock.h"

#include <chrono>

namespace dirt {

namespace {

/// The samples of one frame in the making.
class Samples {
public:
    Samples(const RenderSettings& settings, const Requirements& need, Backend& backend,
            const RenderHooks& hooks, PassClock& clock)
        : settings_(settings), rasterPrimary_(!need.tracedPrimary), traceLight_(need.shadowRays),
          backend_(backend), hooks_(hooks), clock_(clock) {}

    /// The order of the passes of one sample. False if it was given up.
    bool run(uint32_t sample) {
        backend_.beginSample();
        if (rasterPrimary_)
            time("DirectVisibility", 0, [&] { backend_.directVisibility(sample); });
        else
            findPoints(sample, 0);
        if (!lightPoints(sample, 0)) return false;
        for (int k = 1; k < settings_.bounces; ++k) {
            time("DepthMask", k, [&] { backend_.depthMask(k); });
            findPoints(sample, k);
            if (!lightPoints(sample, k)) return false;
        }
        time("Resolve", 0, [&] { backend_.resolve(); });
        return !stopped_;
    }

private:
    template <typename Pass>
    void time(const char* name, int event, const Pass& pass) {
        if (!stopped()) clock_.time(name, event, pass);
    }
    bool stopped() { return stopped_ = stopped_ || (hooks_.stop && hooks_.stop()); }

    /// G[k+1] where the rays of path event \p k hit.
    void findPoints(uint32_t sample, int k) {
        time("Rays", k, [&] { backend_.rays(sample, k); });
        time("Trace", k, [&] { backend_.trace(k); });
        time("Fetch", k, [&] { backend_.fetch(k); });
    }

    bool lightPoints(uint32_t sample, int k) {
        if (traceLight_) time("Visibility", k, [&] { backend_.visibility(k); });
        time("Shade", k, [&] { backend_.shade(k); });
        if (stopped()) return false;
        if (hooks_.observe) hooks_.observe(sample, k);
        backend_.shift();
        return true;
    }

    const RenderSettings& settings_;
    bool rasterPrimary_, traceLight_;
    Backend& backend_;
    const RenderHooks& hooks_;
    PassClock& clock_;
    bool stopped_ = false;
};

} // namespace

Image meanImage(const Backend& backend, const GridSettings& grid, int samples) {
    Image image{grid.width, grid.height, backend.readImage()};
    const float weight = samples > 0 ? 1.0f / (float) samples : 0.0f;
    for (glm::vec3& pixel : image.pixels) pixel *= weight;
    return image;
}

double RenderResult::passMs(const char* name) const {
    double sum = 0.0;
    for (const PassTime& pass : passes)
        if (pass.name == name) sum += pass.ms;
    return sum;
}

Renderer::Renderer(const Scene& scene, const RenderSettings& settings, Backend& backend)
    : scene_(scene), settings_(settings), backend_(backend) {}

RenderResult Renderer::render(const RenderHooks& hooks) {
    const auto start = std::chrono::steady_clock::now();
    RenderResult result;
    Requirements need = requirementsOf(scene_, settings_, backend_.rasterizes());
    need.previousPoint |= previousPoint_;
    backend_.expectLight(need.shadowRays ? &scene_.lights.front() : nullptr);
    result.build = backend_.build(scene_.mesh, scene_.camera, settings_.grid);

    PassClock clock(backend_);
    backend_.beginFrame(scene_, settings_, need);
    if (need.shadowMap > 0) clock.time("ShadowMap", 0, [&] { backend_.shadowMap(); });
    Samples samples(settings_, need, backend_, hooks, clock);
    while (result.samples < settings_.samples && samples.run(first_ + (uint32_t) result.samples)) {
        ++result.samples;
        if (hooks.progress) hooks.progress(result.samples, settings_.samples);
    }
    result.image = meanImage(backend_, settings_.grid, result.samples);
    result.counts = backend_.counts();

    result.passes = result.build;
    const std::vector<PassTime> passes = clock.take();
    result.passes.insert(result.passes.end(), passes.begin(), passes.end());
    result.frameMs =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    return result;
}

} // namespace dirt
