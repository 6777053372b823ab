#pragma once

#include "app/viewer/viewer.h"

#include <string>

namespace dirt {

/// Writes to \p path, as JSON, what the window shows: of the state, the picture and the overlay.
void writeStatus(const std::string& path, const Viewer& viewer, const ViewPicture* shown);

} // namespace dirt
