#include "app/cli/json_report.h"

namespace dirt {

Json vectorJson(glm::dvec3 v) {
    return {v.x, v.y, v.z};
}

Json reportOf(const Input& input, const Backend& backend, const Executor& executor,
              std::span<const PassTime> build) {
    const GridSettings& grid = input.settings.grid;
    Json report;
    report["scene"] = input.scene.name;
    report["animation_frame"] = input.frame;
    report["backend"] = backend.name();
    report["device"] = backend.device();
    report["triangles"] = input.scene.mesh.triangles.size();
    report["view"] = grid.mode == ViewMode::full ? "full" : "single";
    report["views"] = grid.mode == ViewMode::full ? 6 : 1;
    report["tile"] = grid.tile;
    report["bins"] = grid.bins;
    report["exact"] = grid.precision == Precision::exact;
    report["shading"] = input.settings.shading == Shading::full ? "full" : "packed";
    report["size"] = {grid.width, grid.height};
    report["spp"] = input.settings.samples;
    report["bounces"] = input.settings.bounces;
    report["seed"] = input.settings.seed;
    report["threads"] = executor.threads();

    report["passes"] = Json::array();
    for (const PassTime& pass : build)
        report["passes"].push_back({{"name", pass.name}, {"ms", pass.ms}, {"event", pass.event}});
    report["build_ms"] = totalMs(build);

    const std::vector<BufferSize> memory = backend.memory();
    report["memory"] = Json::object();
    for (const BufferSize& buffer : memory) report["memory"][buffer.name] = buffer.bytes;
    report["memory"]["total"] = totalBytes(memory);
    report["list_entries"] = backend.listEntries();
    return report;
}

} // namespace dirt
