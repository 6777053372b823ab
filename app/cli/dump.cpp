#include "core/dump/dump.h"
#include "app/cli/clamped_radiance.h"
#include "app/cli/commands.h"
#include "app/cli/dump_manifest.h"
#include "app/cli/dump_options.h"
#include "app/cli/dump_pixel.h"
#include "app/cli/interrupt.h"
#include "app/cli/log.h"
#include "app/cli/memory_limit.h"
#include "app/cli/option_values.h"
#include "core/base/error.h"
#include "core/dump/manifest.h"
#include "core/frame/memory_plan.h"
#include "core/frame/passes.h"
#include "core/frame/renderer.h"
#include "core/io/input_files.h"
#include "core/io/output_file.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace dirt {

namespace {

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
void noteMissing(const std::vector<std::string>& asked, const std::vector<DumpedFile>& files,
                 bool quiet) {
    std::string missing;
    for (const std::string& name : asked)
        if (std::none_of(files.begin(), files.end(),
                         [&](const DumpedFile& file) { return file.buffer == name; }))
            missing += (missing.empty() ? "" : ",") + name;
    if (!missing.empty()) sayWarning("--buffers " + missing + ": this frame has none", quiet);
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
    if (options.pixel) checkPixelOptions(options);
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
    if (options.pixel) return dumpPixel(options, input, *backend, *executor);
    checkFolder(options.output, wanted, input.settings.bounces, memory);
    makeFolder(options.output);
    // So that none stands beside files that it does not know.
    std::error_code ignored;
    std::filesystem::remove(manifestOf(options.output), ignored);

    const GridSettings& grid = input.settings.grid;
    Dump dump(options.output, grid.width, grid.height,
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
        sayError("stopped; no manifest written");
        return interruptStatus();
    }

    noteClamped(result, options.common.quiet);
    const std::string text =
        dumpManifest(input, *backend, *executor, options.sample, result, dump.files()).dump(2) +
        "\n";
    writeFile(manifestOf(options.output), text);
    if (options.json) std::fputs(text.c_str(), stdout);
    noteMissing(options.buffers, dump.files(), options.common.quiet);
    for (const DumpedFile& file : dump.files())
        sayWritten(options.output + "/" + file.file, options.common.quiet);
    logWritten(manifestOf(options.output));
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
    command
        .addText("-o,--output", options->output,
                 "folder for the files, made if need be; with --pixel FILE.json")
        .required();
    addIntegers(command, "--pixel", 2, 65535, "X,Y",
                "only this pixel, from the top left, counted from 0: what explains it, as JSON",
                [options](const std::vector<int>& at) {
                    options->pixel = std::array{at[0], at[1]};
                });
    addInteger(command, "--event", 0, 1023, "only this path event (default: all)",
               [options](int64_t k) { options->event = (int) k; });
    addInteger(command, "--sample", 0, 0x7fffffff, "of the frame (default: 0)",
               [options](int64_t n) { options->sample = (uint32_t) n; });
    command.addFlag("--json", options->json,
                    "print the manifest, or the pixel, on standard output");
    command.onRun([options, &status] { status = runDump(*options); });
}

} // namespace dirt
