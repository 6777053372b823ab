#pragma once

#include "core/explain/explained_ray.h"
#include "core/preview/picture.h"

#include <optional>
#include <string>

namespace dirt {

/// One ray in the grid: for each view that it enters the tiles, with the cells it looked into,
/// passed over and visited, its image and where it hits; beside them the same way in depth. Below,
/// what the colours mean. \p trail: of \p geometry in \p grid.
Picture drawRay(const Grid& grid, const FrameGeometry& geometry, const RayTrail& trail,
                const std::string& title);

/// The rays of all path events of a pixel, or of one, below each other. Throws InputError where the
/// account has no grid, the path no ray, or the picture would have more than 2^26 pixels.
Picture drawRays(const PathAccount& account, const std::string& title, std::optional<int> event);

} // namespace dirt
