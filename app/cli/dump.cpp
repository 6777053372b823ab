#include "core/dump/dump.h"
#include "app/cli/clamped_radiance.h"
#include "app/cli/commands.h"
#include "app/cli/input.h"
#include "app/cli/interrupt.h"
#include "app/cli/json_report.h"
#include "app/cli/memory_limit.h"
#include "app/cli/option_values.h"
#include "core/base/error.h"
#include "core/dump/manifest.h"
#include "core/frame/memory_plan.h"
#include "core/frame/passes.h"
#include "core/frame/renderer.h"
#include "core/io/input_files.h"
#include "core/io/output_file.h"
#include "core/path/grid_spotlight.h"
#include "core/path/shadow_frustum.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace dirt {

namespace {

struct DumpOptions {
    CommonOptions common;
    std::vector<std::string> buffers; ///< empty: all
    std::string folder;
    std::optional<int> event; ///< none: all
    uint32_t sample = 0;
    bool json = false;
};

/// Which buffers are wanted.
class Selection {
public:
    explicit Selection(const std::vector<std::string>& names) {
        for (const std::string& name : names)
            if (std::find(dumpBuffers().begin(), dumpBuffers().end(), name) == dumpBuffers().end())
                throw InputError("--buffers " + printable(name) + ": there are " + list());
        names_ = names.empty() ? dumpBuffers() : names;
    }
    bool has(const char* name) const {
        return std::find(names_.begin(), names_.end(), name) != names_.end();
    }
    static std::string list() {
        std::string text;
        for (const std::string& name : dumpBuffers()) text += (text.empty() ? "" : ",") + name;
        return text;
    }

private:
    std::vector<std::string> names_;
};

void makeFolder(const std::string& folder) {
    std::error_code error;
    std::filesystem::create_directory(folder, error);
    if (!std::filesystem::is_directory(folder))
        throw InputError(folder + ": cannot make this folder" +
                         (error ? ": " + error.message() : ""));
}

std::string manifestOf(const std::string& folder) {
    return (std::filesystem::path(folder) / "manifest.json").string();
}

/// checkWritable for one of thousands of names in a folder that can be written to.
void checkFile(const std::string& file) {
    std::error_code error;
    if (std::filesystem::exists(std::filesystem::symlink_status(file, error)) ||
        inputUseOf(file) != InputFiles::Use::none)
        checkWritable(file);
}

/// Throws InputError where one of the files of a dump to \p folder cannot be written, or would
/// take the place of what is no dump's. To look at one may take \p available bytes.
void checkFolder(const std::string& folder, const Selection& wanted, int bounces,
                 uint64_t available) {
    if (!std::filesystem::exists(folder)) return;
    const std::string manifest = manifestOf(folder);
    checkWritable(manifest);
    MemoryClaim memory{MemoryBudget(available)};
    if (std::filesystem::exists(manifest) && !isDumpManifest(manifest, memory))
        throw InputError(manifest + ": cannot write: it is not of dirt dump, and would be lost");
    for (const std::string& buffer : dumpBuffers()) {
        if (!wanted.has(buffer.c_str())) continue;
        checkFile(folder + "/" + dumpFileName(buffer, {}));
        if (buffer == "ids") checkFile(folder + "/" + kIdsAsText);
        for (int event = 0; event < bounces; ++event)
            checkFile(folder + "/" + dumpFileName(buffer, event));
    }
}

/// Of buffers that were asked for by name and that the frame does not have.
void noteMissing(const std::vector<std::string>& asked, const std::vector<DumpedFile>& files) {
    std::string missing;
    for (const std::string& name : asked)
        if (std::none_of(files.begin(), files.end(),
                         [&](const DumpedFile& file) { return file.buffer == name; }))
            missing += (missing.empty() ? "" : ",") + name;
    if (!missing.empty())
        std::fprintf(stderr, "dirt: warning: --buffers %s: this frame has none\n", missing.c_str());
}

/// Throws InputError where the buffers, their copy and the largest file, twice while it is being
/// written, would not fit into memory.
void checkDumpMemory(const Input& input, uint64_t available) {
    Requirements need = requirementsOf(input.scene, input.settings, false);
    need.previousPoint = true;
    uint64_t buffers = 0;
    for (const PlannedBuffer& row : planPaths(need, input.settings.grid)) buffers += row.bytes;
    const GridSettings& grid = input.settings.grid;
    const uint64_t shading = 3 * surfacePointChannels().size() * sizeof(uint32_t) *
                             (uint64_t) grid.width * (uint64_t) grid.height;
    const uint64_t needed = 2 * buffers + 2 * shading;
    if (needed > available)
        throw InputError("a dump of " + std::to_string(grid.width) + "x" +
                         std::to_string(grid.height) + " pixels needs " + memoryText(needed) +
                         " of memory; a scene may take " + memoryText(available) + " (--memory)");
}

Json vectorJson(glm::vec3 v) {
    return {v.x, v.y, v.z};
}

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

/// What makes the numbers in the files mean something: the frame, the views and the channels.
Json manifest(const DumpOptions& options, const Input& input, const Backend& backend,
              const Executor& executor, const RenderResult& result,
              const std::vector<DumpedFile>& files) {
    Json json = reportOf(input, backend, executor, result.build);
    for (const char* key : {"passes", "build_ms", "memory", "threads", "spp"}) json.erase(key);
    const GridFrame frame = backend.readGeometry().frame;
    const Requirements need = requirementsOf(input.scene, input.settings, backend.rasterizes());
    json["sample"] = options.sample;
    json["fov"] = input.scene.camera.verticalFov;
    json["cut_outs"] = need.cutOuts;
    json["clamped"] = result.counts.clamped;
    const glm::dvec3 origin = input.scene.origin;
    json["origin"] = {origin.x, origin.y, origin.z};
    json["frame"] = {{"eye", vectorJson(frame.eye)},
                     {"right", vectorJson(frame.right)},
                     {"down", vectorJson(frame.down)},
                     {"forward", vectorJson(frame.forward)},
                     {"scale", frame.scale}};
    if (backend.hasGrid()) {
        const Grid grid = backend.readGrid();
        json["view_frames"] = viewsJson(grid);
        json["at_eye"] = grid.atEye;
    }
    if (need.shadowMap > 0) json["shadow_map"] = shadowMapJson(input.scene, frame);
    json["files"] = filesJson(files);
    return json;
}

void dumpStructure(const Backend& backend, const FrameGeometry& geometry, const Selection& wanted,
                   Dump& dump) {
    if (wanted.has("triangles")) dump.triangles(geometry);
    if (!backend.hasGrid()) return;
    const Grid grid = backend.readGrid();
    if (wanted.has("depth")) dump.depth(grid);
    if (wanted.has("ids")) dump.ids(grid, geometry);
}

/// What the backend has of one path event.
void dumpEvent(const FrameContext& frame, Backend& backend, const PathBuffers& paths, int event,
               const Selection& wanted, Dump& dump) {
    // Rasterized direct visibility has no rays.
    const bool traced = event > 0 || frame.requirements.tracedPrimary;
    if (traced && wanted.has("rays")) dump.rays(paths, event);
    if (traced && wanted.has("hits")) dump.hits(paths, event);
    if (event > 0 && wanted.has("mask")) dump.mask(paths, event);
    if (wanted.has("shadowrays"))
        dump.shadowRays(shadowRecordsOf(frame, backend, event, paths), event);
    if (wanted.has("visibility")) dump.visibility(paths, event);
    if (wanted.has("shading")) dump.shading(paths, event);
    if (wanted.has("image")) dump.image(paths, event);
}

int runDump(const DumpOptions& options) {
    const Selection wanted(options.buffers);
    const auto executor = makeExecutor(options.common);
    Input input = openInput(options.common, *executor);
    input.settings.samples = 1;
    if (options.event && *options.event >= input.settings.bounces)
        throw InputError("--event " + std::to_string(*options.event) + ": the path events of " +
                         std::to_string(input.settings.bounces) + " bounces are 0 to " +
                         std::to_string(input.settings.bounces - 1));
    const uint64_t memory = sceneMemory(options.common);
    checkDumpMemory(input, memory);
    const auto backend = makeBackend(options.common, *executor);
    checkFolder(options.folder, wanted, input.settings.bounces, memory);
    makeFolder(options.folder);
    // So that none stands beside files that it does not know.
    std::error_code ignored;
    std::filesystem::remove(manifestOf(options.folder), ignored);

    const GridSettings& grid = input.settings.grid;
    Dump dump(options.folder, grid.width, grid.height,
              {{"dirt:scene", input.scene.name},
               {"dirt:backend", backend->name()},
               {"dirt:seed", std::to_string(input.settings.seed)},
               {"dirt:sample", std::to_string(options.sample)}});
    const Requirements need = requirementsOf(input.scene, input.settings, backend->rasterizes());
    FrameGeometry geometry; // of the frame
    RenderHooks hooks;
    hooks.stop = interrupted;
    hooks.observe = [&](uint32_t, int event) {
        const bool wantsEvent = !options.event || *options.event == event;
        if (event > 0 && !wantsEvent) return;
        const PathBuffers paths = backend->readPaths();
        if (event == 0) {
            geometry = backend->readGeometry();
            dumpStructure(*backend, geometry, wanted, dump);
            if (wanted.has("shadowmap")) dump.shadowMap(backend->readShadowMap());
            if (wanted.has("direct")) dump.direct(paths);
        }
        if (!wantsEvent) return;
        const FrameContext frame(input.scene, geometry, input.settings, need);
        dumpEvent(frame, *backend, paths, event, wanted, dump);
    };
    catchInterrupts();
    Renderer renderer(input.scene, input.settings, *backend);
    renderer.keepPreviousPoint();
    renderer.beginAt(options.sample);
    const RenderResult result = renderer.render(hooks);
    if (result.samples == 0) {
        std::fprintf(stderr, "dirt: stopped; no manifest written\n");
        return interruptStatus();
    }

    noteClamped(result, options.common.quiet);
    const std::string text =
        manifest(options, input, *backend, *executor, result, dump.files()).dump(2) + "\n";
    writeFile(manifestOf(options.folder), text);
    if (options.json) std::fputs(text.c_str(), stdout);
    if (options.common.quiet) return 0;
    noteMissing(options.buffers, dump.files());
    for (const DumpedFile& file : dump.files())
        std::fprintf(stderr, "%s/%s\n", options.folder.c_str(), file.file.c_str());
    return 0;
}

} // namespace

void addDump(Command program, int& status) {
    const Command command = program.addCommand(
        "dump", "writes the buffers of one sample of a frame as EXR, lists as text, too");
    const auto options = std::make_shared<DumpOptions>();
    addCommonOptions(command, options->common);
    command.addTexts("--buffers", options->buffers, "of " + Selection::list() + " (default: all)")
        .commaSeparated()
        .oneWord();
    command.addText("-o,--output", options->folder, "folder for the files; made if need be")
        .required();
    addInteger(command, "--event", 0, 1023, "only this path event (default: all)",
               [options](int64_t k) { options->event = (int) k; });
    addInteger(command, "--sample", 0, 0x7fffffff, "of the frame (default: 0)",
               [options](int64_t n) { options->sample = (uint32_t) n; });
    command.addFlag("--json", options->json, "print the manifest on standard output");
    command.onRun([options, &status] { status = runDump(*options); });
}

} // namespace dirt
