#include "app/viewer/status_file.h"

#include "app/cli/json_report.h"
#include "core/io/output_file.h"

namespace dirt {

namespace {

Json stateJson(const ViewState& s) {
    const GridSettings& grid = s.settings.grid;
    return {
        {"backend", nameOf(s.backend)},
        {"size", {grid.width, grid.height}},
        {"view", grid.mode == ViewMode::full ? "full" : "single"},
        {"tile", grid.tile},
        {"bins", grid.bins},
        {"max_mip", grid.maxMip},
        {"bounces", s.settings.bounces},
        {"ray_type", (int) s.settings.rayType},
        {"shadow_map", s.settings.visibility == LightVisibility::shadowMap},
        {"progressive", s.progressive},
        {"shown", s.shown->name},
        {"threads", s.threads},
        {"traversal", s.settings.grid.traversal == Traversal::linear ? "linear" : "hierarchical"},
        {"precision", s.settings.grid.precision == Precision::fast ? "fast" : "exact"},
        {"primary", s.settings.primary == Primary::traced ? "traced" : "raster"},
        {"fetch", s.settings.fetch == Fetch::direct ? "direct" : "raster"},
        {"shading", s.settings.shading == Shading::packed ? "packed" : "full"},
        {"frame", s.frame},
        {"playing", s.playing},
        {"level", s.level},
        {"bin", s.bin},
        {"event", s.event},
        {"ray", s.ray ? Json(*s.ray) : Json()},
        {"tile_told", s.tile ? Json(*s.tile) : Json()},
        {"key", s.toneMapping.key},
        {"white", s.toneMapping.white},
        {"eye", vectorJson(s.camera.eye)},
        {"target", vectorJson(s.camera.target)},
        {"aperture_radius", s.camera.apertureRadius},
        {"focal_distance", s.camera.focalDistance}};
}

} // namespace

void writeStatus(const std::string& path, const Viewer& viewer, const ViewPicture* shown) {
    const auto loading = viewer.model.loading();
    Json json{{"loaded", viewer.model.loaded()},
              {"loading", loading ? Json{{"done", loading->done}, {"of", loading->of}} : Json()},
              {"changes", viewer.model.changes()},
              {"problem", viewer.model.problem()},
              {"said", viewer.said},
              {"text", viewer.text},
              {"timers", viewer.timers},
              {"help", viewer.help},
              {"panel", viewer.panel},
              {"under", viewer.under},
              {"zoom", viewer.zoom.times},
              {"step", viewer.step},
              {"file", viewer.model.facts().file}};
    if (viewer.model.loaded()) json["state"] = stateJson(viewer.model.state());
    if (shown)
        json["picture"] = {{"change", shown->change},
                           {"width", shown->width},
                           {"height", shown->height},
                           {"samples", shown->samples},
                           {"error", shown->error},
                           {"done", shown->done},
                           {"frame", shown->frame},
                           {"sample_ms", shown->sampleMs},
                           {"told", shown->told},
                           {"steps", shown->path.size()},
                           {"bytes", totalBytes(shown->memory)}};
    const PathStep* const step = shown ? viewer.stepOf(*shown) : nullptr;
    if (step) json["picture"]["ray_told"] = step->text;
    writeFile(path, json.dump(2) + "\n");
}

} // namespace dirt
