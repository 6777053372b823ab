#include "core/preview/preview.h"
#include "app/cli/commands.h"
#include "app/cli/input.h"
#include "app/cli/interrupt.h"
#include "app/cli/log.h"
#include "app/cli/option_values.h"
#include "app/cli/pixel_option.h"
#include "core/base/error.h"
#include "core/io/image.h"
#include "core/io/load_report.h"
#include "core/io/output_file.h"
#include "core/preview/present.h"

#include <array>
#include <cstdio>
#include <memory>
#include <optional>

namespace dirt {

namespace {

using Of = PreviewKind::Of;

struct PreviewOptions {
    CommonOptions common;
    std::string show = "image", output;
    std::optional<std::string> buffer; ///< of the views in an overview
    std::optional<int> level, bin, event, sample;
    std::optional<PointChoice> point;
    std::optional<std::array<int, 2>> path;
};

const PreviewKind& kindOf(const std::string& name) {
    if (const PreviewKind* kind = previewKind(name)) return *kind;
    throw InputError("--show " + inQuotes(name) + ": dirt preview --list names what there is");
}

/// The buffer of an overview's views.
const PreviewKind* aroundOf(const PreviewOptions& options, const PreviewKind& kind) {
    if (kind.of != Of::overview) return nullptr;
    const std::string name = options.buffer.value_or("entries");
    const PreviewKind* around = previewKind(name);
    if (!around || around->of != Of::views)
        throw InputError("--buffer " + inQuotes(name) + ": one of near, far, entries, first");
    return around;
}

/// Options of kinds that do not look at them.
void refuseIdle(const PreviewOptions& options, const PreviewKind& kind, const PreviewKind* around) {
    const std::string tiles = around ? around->name : kind.name; // what is drawn of them
    const auto refuse = [&](bool given, const char* option, bool honoured) {
        if (given && !honoured)
            throw InputError(std::string(option) + ": has no effect with --show " + kind.name +
                             (around ? std::string(" --buffer ") + around->name : ""));
    };
    const bool ofEvent = kind.of == Of::event || kind.of == Of::point;
    const bool ofPath = options.path && (kind.of == Of::views || kind.of == Of::overview);
    refuse(options.level.has_value(), "--level", tiles == "near" || tiles == "far");
    refuse(options.bin.has_value(), "--bin", tiles == "entries");
    refuse(options.buffer.has_value(), "--buffer", kind.of == Of::overview);
    refuse(options.event.has_value(), "--event", ofEvent || ofPath);
    refuse(options.sample.has_value(), "--sample", ofEvent || ofPath);
    refuse(options.point.has_value(), "--point", kind.of == Of::point);
    refuse(options.path.has_value(), "--path", kind.of != Of::light);
    refuse(options.common.samples.has_value(), "--spp",
           kind.of == Of::image || kind.of == Of::overview);
}

void list() {
    for (const PreviewKind& kind : previewKinds())
        std::printf("%-18s%s\n", kind.name, kind.meaning);
}

PreviewRequest requestOf(const PreviewOptions& options, const PreviewKind& kind,
                         const PreviewKind* around, const RenderSettings& settings) {
    PreviewRequest request;
    request.kind = &kind;
    request.around = around;
    request.level = options.level.value_or(0);
    request.bin = options.bin.value_or(-1);
    request.event = options.event.value_or(0);
    request.sample = (uint32_t) options.sample.value_or(0);
    request.point = options.point.value_or(PointChoice::next);
    if (!options.path) return request;
    checkPixel("--path", *options.path, settings);
    checkEvent(options.event, settings);
    request.path = PathRequest{*options.path, options.event};
    return request;
}

int runPreview(const PreviewOptions& options) {
    const PreviewKind& kind = kindOf(options.show);
    const PreviewKind* around = aroundOf(options, kind);
    refuseIdle(options, kind, around);
    if (imageFormat(options.output) != ImageFormat::png)
        throw InputError(options.output + ": a preview is a PNG; `dirt dump` writes values");
    checkWritable(options.output);
    const auto executor = makeExecutor(options.common);
    const Input input = openInput(options.common, *executor);
    const auto backend = makeBackend(options.common, *executor);
    checkWritable(options.output); // now that the inputs are known
    const PreviewRequest request = requestOf(options, kind, around, input.settings);
    catchInterrupts();
    const PreviewPicture preview =
        drawPreview(input.scene, input.settings, *backend, request, interrupted);
    if (interrupted()) return interruptStatus();
    const Picture picture = present(preview);
    writePng(options.output, picture.width, picture.height, picture.rgb,
             {{"dirt:scene", input.scene.name},
              {"dirt:backend", backend->name()},
              {"dirt:show", kind.name},
              {"dirt:scale", preview.scale}});
    sayWritten(options.output + ": " + kind.name + ", " + preview.scale, options.common.quiet);
    return 0;
}

} // namespace

void addPreview(Command program, int& status) {
    const Command command =
        program.addCommand("preview", "a buffer of the frame as a picture, in false colours");
    const auto options = std::make_shared<PreviewOptions>();
    addCommonOptions(command, options->common);
    command.addText("--show", options->show, "what; --list names all (default: image)");
    command.addText("-o,--output", options->output, "a PNG file").required();
    command.addText("--buffer", options->buffer,
                    "of the views around an overview: near, far, entries or first (default: "
                    "entries)");
    addInteger(command, "--level", 0, 13, "of the pyramid (default: 0, the tiles)",
               [options](int64_t n) { options->level = (int) n; });
    addInteger(command, "--bin", 0, 255, "whose entries are counted (default: all)",
               [options](int64_t n) { options->bin = (int) n; });
    addInteger(command, "--event", 0, 1023, "path event (default: 0; of --path: all)",
               [options](int64_t k) { options->event = (int) k; });
    addInteger(command, "--sample", 0, 0x7fffffff, "(default: 0)",
               [options](int64_t n) { options->sample = (int) n; });
    addChoice(command, "--point", {"previous", "current", "next"},
              "which surface point of event k: G[k-1], G[k] or G[k+1] (default: next)",
              [options](size_t i) { options->point = (PointChoice) i; });
    addIntegers(command, "--path", 2, 65535, "X,Y",
                "marks a pixel; in views the tiles that its rays visit",
                [options](const std::vector<int>& at) {
                    options->path = std::array{at[0], at[1]};
                });
    command.addAction("--list", "what can be shown, and end", list);
    command.onRun([options, &status] { status = runPreview(*options); });
}

} // namespace dirt
