#pragma once

#include "app/viewer/viewer.h"

namespace dirt {

/// All that keys change, and some more, for the mouse.
void drawPanel(Viewer& viewer);

} // namespace dirt
