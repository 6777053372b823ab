#include "core/replay/against.h"

#include "core/check/compare_paths.h"
#include "core/check/compare_structure.h"
#include "core/io/load_report.h"
#include "core/replay/dumped_view.h"
#include "core/replay/judge_structure.h"

namespace dirt {

namespace {

CheckRow& addRow(const std::string& pass, int event, const std::string& buffer,
                 const Backend& backend, std::vector<CheckRow>& rows) {
    CheckRow& row = rows.emplace_back();
    row.pass = pass;
    row.event = event;
    row.buffer = buffer;
    row.tested = "dump";
    row.source = backend.name();
    return row;
}

/// Whether \p backend can build the very views.
void checkViews(const Manifest& manifest, const Grid& built) {
    for (size_t view = 0; view < manifest.views.size(); ++view) {
        const View &a = manifest.views[view], &b = built.views[view];
        if (a.axisX != b.axisX || a.axisY != b.axisY || a.axisW != b.axisW || a.signW != b.signW ||
            a.s != b.s || a.t != b.t)
            failAt(manifest.file, 0,
                   "view_frames[" + std::to_string(view) +
                       "] has other axes or borders than a backend makes of these settings: "
                       "--against cannot build it");
    }
}

void compareStructure(const ReplayInput& input, const Backend& backend,
                      std::vector<CheckRow>& rows) {
    const Grid built = backend.readGrid();
    checkViews(input.manifest, built);
    const size_t levels = input.hasPyramid ? built.pyramids[0].levels.size() : 1;
    for (size_t level = 0; level < levels; ++level)
        compareLevel(
            built, *input.grid, level, kDepthUlps,
            addRow(level == 0 ? "FillDepth" : "FillDepthMipmap", -1,
                   level == 0 ? "depth bounds" : "depth pyramid, level " + std::to_string(level),
                   backend, rows));
    if (input.hasLists)
        compareLists(input.geometry, built, *input.grid, kDepthUlps,
                     addRow("FillPrimitives", -1, "lists", backend, rows));
    if (input.manifest.atEye)
        compareAtEye(built, *input.grid,
                     addRow("FillPrimitives", -1, "triangles at the eye", backend, rows));
}

void compareHits(const ReplayInput& input, const DumpedHits& event, Backend& backend,
                 std::vector<CheckRow>& rows) {
    PathBuffers built, dumped;
    built.hits.resize(event.hits.size());
    backend.intersect(event.rays, built.hits);
    dumped.hits = event.hits;
    for (size_t pixel = 0; pixel < event.rays.size(); ++pixel) {
        const Ray& ray = event.rays[pixel];
        built.rays.push_back({.origin = ray.origin, .skip = ray.skip, .direction = ray.direction});
        if (!dumped.hits[pixel].found())
            dumped.hits[pixel] = built.hits[pixel].found() ? Hit{} : built.hits[pixel];
    }
    const PathTolerance tolerance{false, event.filed && backend.hasGrid(), {}};
    PathComparison(input.geometry, input.manifest.settings.width, tolerance)
        .compare(PathBuffer::hits, built, dumped,
                 addRow("Trace", event.event, "hit buffer", backend, rows));
}

void compareShadows(const ReplayInput& input, const DumpedShadows& event, Backend& backend,
                    std::vector<CheckRow>& rows) {
    PathBuffers built, dumped;
    built.visibility.resize(event.rays.size());
    backend.occluded(event.rays, event.tMax, built.visibility);
    dumped.visibility = event.occluded;
    for (std::vector<uint8_t>* flags : {&built.visibility, &dumped.visibility})
        for (uint8_t& flag : *flags) flag = flag ? 0 : 1; // what is occluded is not visible
    PathComparison(input.geometry, input.manifest.settings.width, {})
        .compare(PathBuffer::visibility, built, dumped,
                 addRow("Visibility", event.event, "shadow rays", backend, rows));
}

} // namespace

std::vector<CheckRow> replayAgainst(const ReplayInput& input, Backend& backend) {
    const Manifest& manifest = input.manifest;
    if (manifest.settings.mode == ViewMode::single && !manifest.fov)
        failAt(manifest.file, 0, "has no fov, which --against needs in single view");
    backend.build(input.geometry, dumpedCamera(manifest.fov), manifest.settings);
    std::vector<CheckRow> rows;
    if (input.grid && backend.hasGrid()) compareStructure(input, backend, rows);
    for (const DumpedHits& event : input.events) compareHits(input, event, backend, rows);
    for (const DumpedShadows& event : input.shadows) compareShadows(input, event, backend, rows);
    return rows;
}

} // namespace dirt
