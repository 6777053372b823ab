#include "core/dump/shadow_rays.h"

namespace dirt {

namespace {

void addBlocker(const std::vector<View>& views, const Hit& hit, ShadowRecord& record) {
    if (!hit.found() || !(hit.t < record.tMax)) return;
    record.blocker = hit.primitive;
    record.t = hit.t;
    record.view = hit.view;
    if (hit.view >= views.size()) return; // at the eye
    const auto columns = (uint32_t) views[hit.view].columns;
    record.column = hit.tile % columns;
    record.row = hit.tile / columns;
}

} // namespace

std::vector<ShadowRecord> shadowRecordsOf(const FrameContext& frame, Backend& backend, int event,
                                          const PathBuffers& paths) {
    if (!frame.requirements.shadowRays) return {};
    std::vector<ShadowRecord> records(paths.pixels());
    std::vector<size_t> pixels;
    std::vector<Ray> rays;
    for (size_t pixel = 0; pixel < records.size(); ++pixel) {
        const std::optional<ShadowRay> shadow = shadowRay(frame, event, paths, pixel);
        if (!shadow) continue;
        ShadowRecord& record = records[pixel];
        record.origin = shadow->ray.origin;
        record.skip = shadow->ray.skip;
        record.direction = shadow->ray.direction;
        record.tMax = shadow->maxT;
        record.occluded = paths.visibility[pixel] ? 0 : 1;
        pixels.push_back(pixel);
        rays.push_back(shadow->ray);
    }
    std::vector<Hit> hits(rays.size());
    backend.intersect(rays, hits);
    const std::vector<View> views = makeViews(frame.settings.grid, frame.scene.camera);
    for (size_t i = 0; i < hits.size(); ++i) addBlocker(views, hits[i], records[pixels[i]]);
    return records;
}

} // namespace dirt
