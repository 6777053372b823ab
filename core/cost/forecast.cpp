#include "core/cost/forecast.h"

#include "core/frame/renderer.h"

namespace dirt {

Forecast forecastFrame(const Scene& scene, const RenderSettings& settings, Backend& backend) {
    RenderSettings one = settings;
    one.samples = 1;
    const RenderResult first = Renderer(scene, one, backend).render();
    Forecast forecast;
    for (const PassTime& pass : first.passes) forecast.sampleMs += pass.ms;
    for (const PassTime& pass : first.build) forecast.buildMs += pass.ms;
    const double once = forecast.buildMs + first.passMs("ShadowMap");
    forecast.sampleMs -= once;
    forecast.frameMs = once + settings.samples * forecast.sampleMs;
    forecast.rays = (double) settings.samples * (double) first.counts.rays;
    forecast.shadowRays = (double) settings.samples * (double) first.counts.shadowRays;
    for (const BufferSize& buffer : backend.memory()) forecast.memory += buffer.second;
    return forecast;
}

} // namespace dirt
