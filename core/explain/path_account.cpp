#include "core/explain/path_account.h"

#include "core/frame/renderer.h"

namespace dirt {

namespace {

/// The event that has just been shaded. \p path: the pixel's records; \p before: the radiance that
/// it had gathered.
EventAccount eventOf(const FrameContext& frame, int event, const PathBuffers& path, size_t pixel,
                     uint32_t sample, glm::vec3 before) {
    EventAccount account;
    account.event = event;
    account.rasterized = event == 0 && !frame.requirements.tracedPrimary;
    if (account.rasterized) {
        account.ray = primaryRay(frame, pixel, sample);
    } else {
        account.ray = path.rays[0];
        account.hit = path.hits[0];
    }
    account.point = path.next[0];
    account.shadowRay = shadowRay(frame, event, path, 0);
    account.lit = account.shadowRay && path.visibility[0] != 0;
    account.gathered = path.radiance[0];
    account.added = account.gathered - before;
    const glm::vec3 throughput = event == 0 ? glm::vec3(1.0f) : account.ray.throughput;
    const bool seesBackground = event == 0 || frame.settings.grid.mode == ViewMode::full;
    if (frame.settings.rayType == RayType::visibility)
        account.emitted = account.added;
    else if (account.point.found())
        account.emitted = throughput * account.point.emission;
    else if (seesBackground)
        account.emitted = throughput * frame.scene.background;
    account.reflected = account.added - account.emitted;
    return account;
}

} // namespace

PathAccount accountOf(const Scene& scene, RenderSettings settings, Backend& backend, size_t pixel,
                      uint32_t sample, const std::function<bool()>& stop) {
    settings.samples = 1;
    PathAccount account;
    account.pixel = pixel;
    account.sample = sample;
    const Requirements need = requirementsOf(scene, settings, backend.rasterizes());
    RenderHooks hooks;
    bool ended = false; // nothing more happens to the pixel
    hooks.stop = [&] { return ended || (stop && stop()); };
    hooks.observe = [&](uint32_t, int event) {
        if (event == 0) {
            account.geometry = backend.readGeometry();
            account.geometry.cutOuts = need.cutOuts ? &scene : nullptr;
            if (backend.hasGrid()) account.grid = backend.readGrid();
        }
        const FrameContext frame(scene, account.geometry, settings, need);
        const PathBuffers path = backend.readPath(pixel);
        ended = !path.alive(event, 0);
        if (ended) return;
        account.events.push_back(eventOf(frame, event, path, pixel, sample, account.radiance));
        account.radiance = path.radiance[0];
        ended = !account.events.back().point.found() || event + 1 == settings.bounces;
    };
    Renderer renderer(scene, settings, backend);
    renderer.beginAt(sample);
    renderer.render(hooks);
    return account;
}

} // namespace dirt
