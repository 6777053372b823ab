#pragma once

#include "app/viewer/viewer.h"

namespace dirt {

/// What the window writes over its picture: figures, times, problems, the list of keys.
void drawOverlay(const Viewer& viewer, const ViewPicture* shown, double framesPerSecond);

} // namespace dirt
