#include "core/cost/forecast.h"

#include "core/frame/renderer.h"

namespace dirt {

Forecast forecastFrame(const Scene& scene, const RenderSettings& settings, Backend& backend) {
    RenderSettings one = settings;
    one.samples = 1;
    const RenderResult first = Renderer(scene, one, backend).render();
    Forecast forecast;
    forecast.sampleMs = totalMs(first.passes);
    forecast.buildMs = totalMs(first.build);
    const double once = forecast.buildMs + first.passMs("ShadowMap");
    forecast.sampleMs -= once;
    forecast.frameMs = once + settings.samples * forecast.sampleMs;
    forecast.rays = (double) settings.samples * (double) first.counts.rays;
    forecast.shadowRays = (double) settings.samples * (double) first.counts.shadowRays;
    forecast.memory = totalBytes(backend.memory());
    return forecast;
}

} // namespace dirt
