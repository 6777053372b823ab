#pragma once

#include "app/viewer/placement.h"
#include "core/preview/marks.h"

#include <vector>

namespace dirt {

/// Draws marks of a picture over it in the window, as sharp as the window is, however it is zoomed.
void drawMarksOver(const std::vector<Mark>& marks, const Placement& placed);

} // namespace dirt
