#include "app/cli/commands.h"
#include "app/cli/options.h"
#include "core/base/error.h"
#ifdef DIRT_HAVE_VIEWER
#include "app/viewer/window.h"
#endif

#include <memory>

namespace dirt {

namespace {

#ifdef DIRT_HAVE_VIEWER
using Options = ViewerOptions;
void run(const Options& options) {
    runViewer(options);
}
#else
struct Options {
    CommonOptions common;
    std::string status;
};
void run(const Options&) {
    throw CapabilityError(
        "view: this build has no viewer: it needs GLFW and Dear ImGui (the packages "
        "libglfw3-dev and libimgui-dev)");
}
#endif

} // namespace

void addView(Command program, int& status) {
    const Command command = program.addCommand("view", "walks through a scene in a window");
    const auto options = std::make_shared<Options>();
    addCommonOptions(command, options->common);
    command.addText("--status", options->status,
                    "write what the window shows to FILE.json, with each of its frames");
    command.onRun([options, &status] {
        run(*options);
        status = 0;
    });
}

} // namespace dirt
