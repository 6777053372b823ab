#pragma once

#include "core/grid/view.h"

#include <optional>

namespace dirt {

/// Gives dumped views, of which the borders are known, the guard-banded ones: those of makeViews
/// where its borders are the same, else kGuardBand of a tile beyond the dumped ones.
/// \p fov: of the camera in single mode, degrees, where the dump has it.
void addGuardBands(std::vector<View>& views, const GridSettings& settings,
                   std::optional<float> fov);

/// \p view with guard-banded borders that are \p part of a tile wide.
View withGuardBand(View view, int tile, double part);

/// What stands for the camera of a dump: the grid frame's origin and axes, where only the field of
/// view matters.
Camera dumpedCamera(std::optional<float> fov);

} // namespace dirt
