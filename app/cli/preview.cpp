#include "core/preview/preview.h"
#include "app/cli/commands.h"
#include "app/cli/input.h"
#include "app/cli/interrupt.h"
#include "app/cli/option_values.h"
#include "core/base/error.h"
#include "core/io/image.h"
#include "core/io/load_report.h"
#include "core/io/output_file.h"

#include <cstdio>
#include <memory>
#include <optional>

namespace dirt {

namespace {

struct PreviewOptions {
    CommonOptions common;
    std::string show = "image", output;
    std::optional<int> level, bin, event, sample;
};

const PreviewKind& kindOf(const std::string& name) {
    for (const PreviewKind& kind : previewKinds())
        if (name == kind.name) return kind;
    throw InputError("--show " + inQuotes(name) + ": dirt preview --list names what there is");
}

/// Options of kinds that do not look at them.
void refuseIdle(const PreviewOptions& options, const PreviewKind& kind) {
    const std::string name = kind.name;
    const auto refuse = [&](bool given, const char* option, bool honoured) {
        if (given && !honoured)
            throw InputError(std::string(option) + ": has no effect with --show " + name);
    };
    refuse(options.level.has_value(), "--level", name == "near" || name == "far");
    refuse(options.bin.has_value(), "--bin", name == "entries");
    refuse(options.event.has_value(), "--event", kind.perEvent);
    refuse(options.sample.has_value(), "--sample", kind.perEvent);
    refuse(options.common.samples.has_value(), "--spp", name == "image");
}

void list() {
    for (const PreviewKind& kind : previewKinds())
        std::printf("%-18s%s\n", kind.name, kind.meaning);
}

int runPreview(const PreviewOptions& options) {
    const PreviewKind& kind = kindOf(options.show);
    refuseIdle(options, kind);
    if (imageFormat(options.output) != ImageFormat::png)
        throw InputError(options.output + ": a preview is a PNG; `dirt dump` writes values");
    checkWritable(options.output);
    const auto executor = makeExecutor(options.common);
    const Input input = openInput(options.common, *executor);
    const auto backend = makeBackend(options.common, *executor);
    checkWritable(options.output); // now that the inputs are known
    catchInterrupts();
    const PreviewRequest request{&kind, options.level.value_or(0), options.bin.value_or(-1),
                                 options.event.value_or(0), (uint32_t) options.sample.value_or(0)};
    const PreviewPicture picture =
        drawPreview(input.scene, input.settings, *backend, request, interrupted);
    if (interrupted()) return interruptStatus();
    writePng(options.output, picture.width, picture.height, picture.rgb,
             {{"dirt:scene", input.scene.name},
              {"dirt:backend", backend->name()},
              {"dirt:show", kind.name},
              {"dirt:scale", picture.scale}});
    if (!options.common.quiet)
        std::fprintf(stderr, "%s: %s, %s\n", options.output.c_str(), kind.name,
                     picture.scale.c_str());
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
    addInteger(command, "--level", 0, 13, "of the pyramid (default: 0, the tiles)",
               [options](int64_t n) { options->level = (int) n; });
    addInteger(command, "--bin", 0, 255, "whose entries are counted (default: all)",
               [options](int64_t n) { options->bin = (int) n; });
    addInteger(command, "--event", 0, 1023, "path event (default: 0)",
               [options](int64_t k) { options->event = (int) k; });
    addInteger(command, "--sample", 0, 0x7fffffff, "(default: 0)",
               [options](int64_t n) { options->sample = (int) n; });
    command.addAction("--list", "what can be shown, and end", list);
    command.onRun([options, &status] { status = runPreview(*options); });
}

} // namespace dirt
