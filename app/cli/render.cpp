#include "app/cli/clamped_radiance.h"
#include "app/cli/commands.h"
#include "app/cli/image_metadata.h"
#include "app/cli/input.h"
#include "app/cli/interrupt.h"
#include "app/cli/json_report.h"
#include "app/cli/log.h"
#include "app/cli/option_values.h"
#include "app/cli/progress_bar.h"
#include "core/aov/aovs.h"
#include "core/base/error.h"
#include "core/frame/renderer.h"
#include "core/io/image.h"
#include "core/io/input_files.h"
#include "core/io/output_file.h"
#include "core/path/tone_mapping.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace dirt {

namespace {

/// Frames to render, one picture each.
struct FrameRange {
    int first = 0, last = 0;

    int64_t count() const { return (int64_t) last - first + 1; }
};

struct RenderOptions {
    CommonOptions common;
    std::optional<FrameRange> frames; ///< none: the one of the common options
    std::string output;               ///< empty: the scene's name with .png, in the current folder
    std::string stats;                ///< empty: none
    std::vector<std::string> aovs;    ///< layers beside the image
    bool json = false;
};

/// NAME.0007.png for frame 7 of NAME.png.
std::string numbered(const std::string& path, int frame) {
    const std::filesystem::path file(path);
    char number[16];
    std::snprintf(number, sizeof number, ".%04d", frame);
    return (file.parent_path() / file.stem()).string() + number + file.extension().string();
}

/// A picture's name that stands for nothing else: NAME-render.png, or the like.
std::string freeName(const std::string& name) {
    std::string free = name + "-render.png";
    for (int i = 2; std::filesystem::exists(free); ++i)
        free = name + "-render-" + std::to_string(i) + ".png";
    return free;
}

void writeImage(const std::string& path, const Input& input, const RenderResult& result,
                const Aovs& aovs) {
    const Image& image = result.image;
    const ImageMetadata metadata = metadataOf(input, input.settings, result.samples);
    if (!aovs.empty()) {
        const ExrPart picture = aovs.picture(image);
        writeExr(path, std::span(&picture, 1), metadata);
        return;
    }
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
    json["clamped"] = result.counts.clamped;
    return json;
}

/// Renders the frames that are asked for and writes each picture when it is done.
class Render {
public:
    explicit Render(const RenderOptions& options)
        : options_(options), common_(options.common), executor_(makeExecutor(common_)) {}

    int run() {
        checkOutputs();
        input_ = openInput(common_, *executor_);
        output_ = options_.output.empty() ? input_.scene.name + ".png" : options_.output;
        if (!options_.stats.empty()) checkWritable(options_.stats); // now that its inputs are known
        checkAovs();
        const FrameRange frames = options_.frames.value_or(FrameRange{input_.frame, input_.frame});
        checkFrames(frames);
        if (options_.frames && input_.scene.animation.empty())
            sayWarning("--frames: the scene does not move: all are alike", common_.quiet);
        backend_ = makeBackend(common_, *executor_);

        catchInterrupts();
        int status = 0;
        {
            ProgressBar bar(common_.quiet);
            bar.show(0, frames.count() * input_.settings.samples);
            for (int k = frames.first; k <= frames.last && status == 0; ++k)
                status = renderFrame(k, k - frames.first, frames.count(), bar);
        }
        writeReports();
        return status;
    }

private:
    void checkOutputs() {
        aovs_ = aovKindsOf(options_.aovs);
        if (options_.frames && common_.frame)
            throw InputError("--frame and --frames exclude each other");
        if (!options_.output.empty()) {
            imageFormat(options_.output);
            if (!options_.frames) checkWritable(options_.output);
        }
        if (!options_.stats.empty()) checkWritable(options_.stats);
    }

    /// Layers that have nowhere to go, no samples to be made of, or no room.
    void checkAovs() const {
        if (options_.aovs.empty()) return;
        if (imageFormat(output_) == ImageFormat::png)
            throw InputError("--aov: " + output_ + ": a PNG has no layers; name an EXR, as in -o " +
                             input_.scene.name + ".exr");
        if (input_.settings.samples == 1 && std::find(options_.aovs.begin(), options_.aovs.end(),
                                                      "variance") != options_.aovs.end())
            throw InputError("--aov variance: one sample has none; --spp 2 or more");
        const GridSettings& grid = input_.settings.grid;
        const uint64_t bytes = aovBytes(aovs_, (uint64_t) grid.width * (uint64_t) grid.height);
        const MemoryUse& memory = input_.memory;
        if (memory.scene + memory.frame + bytes > memory.limit)
            throw InputError("--aov: these layers need " + memoryText(bytes) + " beside the " +
                             memoryText(memory.scene + memory.frame) +
                             " of scene and frame; they may take " + memoryText(memory.limit) +
                             " in all (--memory)");
    }

    /// The scene's name may be that of a texture beside it.
    void checkPicture(const std::string& path) const {
        const InputFiles::Use use = inputUseOf(path);
        const bool isNamed = use == InputFiles::Use::read || use == InputFiles::Use::wanted;
        if (options_.output.empty() && isNamed)
            throw InputError(path + ": cannot write: " + common_.scene +
                             " uses a file of this name; give the picture another, as in -o " +
                             freeName(input_.scene.name));
        checkWritable(path);
        if (!options_.stats.empty() && isSamePlace(path, options_.stats))
            throw InputError("--stats " + options_.stats + ": the picture is written there");
    }

    /// That none will fail after the ones before it have been rendered.
    void checkFrames(const FrameRange& frames) {
        for (int k = frames.first; k <= frames.last; ++k) {
            if (k != input_.frame) moveInput(input_, common_, k, *executor_);
            checkPicture(outputOf(k));
        }
    }

    std::string outputOf(int frame) const {
        return options_.frames ? numbered(output_, frame) : output_;
    }

    /// \p place: of the frame among \p count. Returns the exit status.
    int renderFrame(int frame, int64_t place, int64_t count, ProgressBar& bar) {
        if (frame != input_.frame) {
            moveInput(input_, common_, frame, *executor_);
            checkPrecision(input_, common_, *executor_);
        }
        Aovs aovs(aovs_, input_.scene, input_.settings);
        RenderHooks hooks;
        hooks.stop = interrupted;
        hooks.progress = [&](int done, int total) {
            aovs.finishSample();
            bar.show(place * total + done, count * total);
        };
        if (!aovs.empty())
            hooks.observe = [&](uint32_t, int event) { aovs.observe(*backend_, event); };
        const RenderResult result =
            Renderer(input_.scene, input_.settings, *backend_).render(hooks);
        const bool stopped = result.samples < input_.settings.samples;
        // Of several frames, those that are there have all their samples.
        const bool written = result.samples > 0 && !(stopped && options_.frames);
        if (stopped) bar.clear();
        if (stopped && options_.frames)
            sayError("stopped in frame " + std::to_string(frame) + ", " + std::to_string(place) +
                     " frames written");
        else if (stopped)
            sayError("stopped after " + std::to_string(result.samples) + " of " +
                     std::to_string(input_.settings.samples) + " samples" +
                     (written ? "" : ", no image written"));
        if (result.counts.clamped > 0) bar.clear();
        noteClamped(result, common_.quiet);
        if (written) {
            writeImage(outputOf(frame), input_, result, aovs);
            bar.clear();
            sayWritten(outputOf(frame), common_.quiet);
        }
        if ((written || !options_.frames) && (options_.json || !options_.stats.empty()))
            reports_.push_back(report(input_, *backend_, *executor_, result));
        return stopped ? interruptStatus() : 0;
    }

    void writeReports() const {
        if (!options_.json && options_.stats.empty()) return;
        const Json json = options_.frames ? Json{{"frames", reports_}} : reports_.front();
        const std::string text = json.dump(2) + "\n";
        if (!options_.stats.empty()) {
            writeFile(options_.stats, text);
            logWritten(options_.stats);
        }
        if (options_.json) std::fputs(text.c_str(), stdout);
    }

    const RenderOptions& options_;
    const CommonOptions& common_;
    std::string output_; ///< numbered where there are several frames
    std::unique_ptr<Executor> executor_;
    std::unique_ptr<Backend> backend_;
    Input input_;
    std::vector<const AovKind*> aovs_;
    std::vector<Json> reports_; ///< of each frame, where they are asked for
};

} // namespace

void addRender(Command program, int& status) {
    const Command command = program.addCommand("render", "renders an image");
    const auto options = std::make_shared<RenderOptions>();
    addCommonOptions(command, options->common);
    command.addText("-o,--output", options->output,
                    "FILE.png or FILE.exr; default: the scene's name with .png, in the current "
                    "folder");
    addRange(command, "--frames", kMaxFrame, "frames of an animated scene, as NAME.0007.png",
             [options](int first, int last) {
                 options->frames = FrameRange{first, last};
             });
    command.addTexts("--aov", options->aovs, "layers beside the image in the EXR: of " + aovNames())
        .commaSeparated()
        .oneWord();
    command.addText("--stats", options->stats, "write what the run measured to FILE.json");
    command.addFlag("--json", options->json, "print the same on standard output");
    command.onRun([options, &status] { status = Render(*options).run(); });
}

} // namespace dirt
