#include "app/cli/commands.h"
#include "app/cli/input.h"
#include "app/cli/interrupt.h"
#include "app/cli/json_report.h"
#include "app/cli/progress_bar.h"
#include "core/frame/renderer.h"
#include "core/io/image.h"
#include "core/io/output_file.h"
#include "core/path/tone_mapping.h"

#include <cstdio>
#include <memory>
#include <string>

namespace dirt {

namespace {

struct RenderOptions {
    CommonOptions common;
    std::string output; ///< empty: the scene's name with .png, in the current folder
    std::string stats;  ///< empty: none
    bool json = false;
};

/// What the image file says of itself. Nothing that differs between runs, so that equal renders
/// are equal files.
ImageMetadata describe(const Input& input, const RenderResult& result) {
    const RenderSettings& settings = input.settings;
    const bool full = settings.grid.mode == ViewMode::full;
    return {{"dirt:scene", input.scene.name},
            {"dirt:samples", std::to_string(result.samples)},
            {"dirt:bounces", std::to_string(settings.bounces)},
            {"dirt:seed", std::to_string(settings.seed)},
            {"dirt:view", full ? "full" : "single"}};
}

void writeImage(const std::string& path, const Input& input, const RenderResult& result) {
    const Image& image = result.image;
    const ImageMetadata metadata = describe(input, result);
    if (imageFormat(path) == ImageFormat::exr) {
        writeExr(path, image, metadata);
        return;
    }
    const DisplayEncoding encode(input.scene.toneMapping);
    writePng(path, image.width, image.height, encode.bytes(image.pixels), metadata);
}

Json report(const Input& input, const Backend& backend, const Executor& executor,
            const RenderResult& result) {
    Json json = reportOf(input, backend, executor, result.build);
    json["spp"] = result.samples;
    json["passes"] = Json::array();
    for (const PassTime& pass : result.passes)
        json["passes"].push_back({{"name", pass.name}, {"ms", pass.ms}, {"event", pass.event}});
    json["trace_ms"] = result.passMs("Trace");
    json["frame_ms"] = result.frameMs;
    json["rays"] = result.counts.rays;
    json["hits"] = result.counts.hits;
    json["shadow_rays"] = result.counts.shadowRays;
    return json;
}

RenderResult render(const RenderOptions& options, const Input& input, Backend& backend) {
    ProgressBar bar(options.common.quiet);
    RenderHooks hooks;
    hooks.progress = [&bar](int done, int total) { bar.show(done, total); };
    hooks.stop = interrupted;
    bar.show(0, input.settings.samples);
    return Renderer(input.scene, input.settings, backend).render(hooks);
}

int runRender(const RenderOptions& options) {
    if (!options.output.empty()) {
        imageFormat(options.output);
        checkWritable(options.output);
    }
    if (!options.stats.empty()) checkWritable(options.stats);

    const auto executor = makeExecutor(options.common);
    const Input input = openInput(options.common, *executor);
    const std::string output = options.output.empty() ? input.scene.name + ".png" : options.output;
    checkWritable(output);
    const auto backend = makeBackend(options.common, *executor);

    catchInterrupts();
    const RenderResult result = render(options, input, *backend);
    const bool stopped = result.samples < input.settings.samples;
    if (stopped)
        std::fprintf(stderr, "dirt: stopped after %d of %d samples%s\n", result.samples,
                     input.settings.samples, result.samples == 0 ? ", no image written" : "");
    if (result.samples > 0) {
        writeImage(output, input, result);
        if (!options.common.quiet) std::fprintf(stderr, "%s\n", output.c_str());
    }

    const std::string text = report(input, *backend, *executor, result).dump(2) + "\n";
    if (!options.stats.empty()) writeFile(options.stats, text);
    if (options.json) std::fputs(text.c_str(), stdout);
    return stopped ? kInterrupted : 0;
}

} // namespace

void addRender(CLI::App& program, int& status) {
    CLI::App* command = program.add_subcommand("render", "renders an image");
    const auto options = std::make_shared<RenderOptions>();
    addCommonOptions(*command, options->common);
    command->add_option("-o,--output", options->output,
                        "FILE.png or FILE.exr; default: the scene's name with .png, in the current "
                        "folder");
    command->add_option("--stats", options->stats, "write what the run measured to FILE.json");
    command->add_flag("--json", options->json, "print the same on standard output");
    command->callback([options, &status] { status = runRender(*options); });
}

} // namespace dirt
