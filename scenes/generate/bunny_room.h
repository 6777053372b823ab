#pragma once

#include "scenes/generate/mesh.h"

namespace dirt::generate {

// The corner, in metres: the left wall with the window, the back wall; open towards the viewer.
constexpr double roomLeft = -1.75;
constexpr double roomRight = 2.3;
constexpr double roomBack = -1.65;
constexpr double roomHeight = 2.7;

/// Boards, walls with wainscot and wallpaper, the window with its curtains, the rug, the picture.
void addRoom(Mesh& mesh);

} // namespace dirt::generate
