#pragma once

#include "app/cli/options.h"

#include <string>

namespace dirt {

struct ViewerOptions {
    CommonOptions common;
    std::string title;  ///< of the window; empty: the scene's file
    std::string status; ///< a file that says what is shown, written with each frame; empty: none
};

/// Opens a window on the scene, until it is closed. Throws CapabilityError where there is no
/// display.
void runViewer(const ViewerOptions& options);

} // namespace dirt
