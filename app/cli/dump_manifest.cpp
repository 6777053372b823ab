#include "app/cli/dump_manifest.h"

#include "core/path/grid_spotlight.h"
#include "core/path/shadow_frustum.h"

namespace dirt {

Json vectorJson(glm::vec3 v) {
    return {v.x, v.y, v.z};
}

namespace {

Json viewsJson(const Grid& grid) {
    Json views = Json::array();
    for (size_t i = 0; i < grid.views.size(); ++i) {
        const View& view = grid.views[i];
        views.push_back({{"name", viewName(grid, i)},
                         {"axes", {view.axisX, view.axisY, view.axisW}},
                         {"sign", view.signW},
                         {"size", {view.width, view.height}},
                         {"tiles", {view.columns, view.rows}},
                         {"s", view.s},
                         {"t", view.t}});
    }
    return views;
}

/// What texels of the map stand for, in the grid frame.
Json shadowMapJson(const Scene& scene, const GridFrame& frame) {
    const GridSpotlight light = makeGridSpotlight(scene.lights.front(), frame);
    const ShadowMap map = makeShadowMap(scene, frame);
    return {{"position", vectorJson(light.position)},
            {"right", vectorJson(light.right)},
            {"up", vectorJson(light.up)},
            {"axis", vectorJson(light.axis)},
            {"extent", map.extent},
            {"bias", map.bias},
            {"softness", map.softness}};
}

Json filesJson(const std::vector<DumpedFile>& files) {
    Json list = Json::array();
    for (const DumpedFile& file : files) {
        Json channels = Json::array();
        for (const ChannelInfo& info : file.channels)
            channels.push_back(
                {{"name", info.inFile},
                 {"type", info.channel.type == ExrChannel::Type::uint32 ? "uint32" : "float32"},
                 {"space", info.space},
                 {"unit", info.unit},
                 {"meaning", info.meaning}});
        list.push_back({{"file", file.file},
                        {"buffer", file.buffer},
                        {"event", file.event ? Json(*file.event) : Json()},
                        {"parts", file.parts},
                        {"channels", channels}});
    }
    return list;
}

} // namespace

Json dumpReport(const Input& input, const Backend& backend, const Executor& executor,
                uint32_t sample, const GridFrame& frame) {
    Json json = reportOf(input, backend, executor, {});
    for (const char* key : {"passes", "build_ms", "memory", "threads", "spp"}) json.erase(key);
    json["sample"] = sample;
    json["fov"] = input.scene.camera.verticalFov;
    json["cut_outs"] = requirementsOf(input.scene, input.settings, backend.rasterizes()).cutOuts;
    const glm::dvec3 origin = input.scene.origin;
    json["origin"] = {origin.x, origin.y, origin.z};
    json["frame"] = {{"eye", vectorJson(frame.eye)},
                     {"right", vectorJson(frame.right)},
                     {"down", vectorJson(frame.down)},
                     {"forward", vectorJson(frame.forward)},
                     {"scale", frame.scale}};
    return json;
}

Json dumpManifest(const Input& input, const Backend& backend, const Executor& executor,
                  uint32_t sample, const RenderResult& result,
                  const std::vector<DumpedFile>& files) {
    const GridFrame frame = backend.readGeometry().frame;
    Json json = dumpReport(input, backend, executor, sample, frame);
    json["clamped"] = result.counts.clamped;
    if (backend.hasGrid()) {
        const Grid grid = backend.readGrid();
        json["view_frames"] = viewsJson(grid);
        json["at_eye"] = grid.atEye;
    }
    if (requirementsOf(input.scene, input.settings, backend.rasterizes()).shadowMap > 0)
        json["shadow_map"] = shadowMapJson(input.scene, frame);
    json["files"] = filesJson(files);
    return json;
}

} // namespace dirt
