#pragma once

#include "core/explain/path_account.h"
#include "core/preview/preview.h"

#include <string>
#include <vector>

namespace dirt {

// What the viewer tells of a pixel's rays and of a tile's lists: the text of `dirt explain`.

/// All rays of a path, then each of them alone.
std::vector<PathRequest> stepsOf(const PathAccount& account, std::array<int, 2> pixel);

/// Of all rays a line each, of one alone all that `explain` has.
std::string pathText(const Scene& scene, const PathAccount& account, const PathRequest& shown);

/// The entries of a tile that exists, and those that are missing.
std::string tileText(const Scene& scene, const Grid& grid, const FrameGeometry& geometry,
                     std::array<int, 3> tile);

} // namespace dirt
