#include "app/cli/commands.h"
#include "app/viewer/window.h"
#include "core/base/error.h"

#include <memory>

namespace dirt {

namespace {

void run([[maybe_unused]] const ViewerOptions& options) {
#ifdef DIRT_HAVE_VIEWER
    runViewer(options);
#else
    throw CapabilityError(
        "view: this build has no viewer: it needs GLFW and Dear ImGui (the packages "
        "libglfw3-dev and libimgui-dev)");
#endif
}

} // namespace

void addView(Command program, int& status) {
    const Command command = program.addCommand("view", "walks through a scene in a window");
    const auto options = std::make_shared<ViewerOptions>();
    addCommonOptions(command, options->common);
    command.addText("--title", options->title, "of the window (default: dirt and SCENE)");
    command.addText("--status", options->status,
                    "write what the window shows to FILE.json, with each of its frames");
    command.onRun([options, &status] {
        run(*options);
        status = 0;
    });
}

} // namespace dirt
