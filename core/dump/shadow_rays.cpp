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

ShadowRecord shadowRecordOf(const ShadowRay& shadow, bool occluded) {
    ShadowRecord record;
    record.origin = shadow.ray.origin;
    record.skip = shadow.ray.skip;
    record.direction = shadow.ray.direction;
    record.tMax = shadow.maxT;
    record.occluded = occluded ? 1 : 0;
    return record;
}

void findBlockers(Backend& backend, const std::vector<View>& views,
                  std::span<ShadowRecord> records) {
    std::vector<ShadowRecord*> cast;
    std::vector<Ray> rays;
    for (ShadowRecord& record : records) {
        if (record.direction == glm::vec3(0.0f)) continue;
        cast.push_back(&record);
        rays.push_back({record.origin, record.direction, record.skip});
    }
    std::vector<Hit> hits(rays.size());
    backend.intersect(rays, hits);
    for (size_t i = 0; i < hits.size(); ++i) addBlocker(views, hits[i], *cast[i]);
}

std::vector<ShadowRecord> shadowRecordsOf(const FrameContext& frame, Backend& backend, int event,
                                          const PathBuffers& paths) {
    if (!frame.requirements.shadowRays) return {};
    std::vector<ShadowRecord> records(paths.pixels());
    for (size_t pixel = 0; pixel < records.size(); ++pixel)
        if (const auto shadow = shadowRay(frame, event, paths, pixel))
            records[pixel] = shadowRecordOf(*shadow, paths.visibility[pixel] == 0);
    findBlockers(backend, makeViews(frame.settings.grid, frame.scene.camera), records);
    return records;
}

} // namespace dirt
