#pragma once

#include "core/frame/settings.h"

#include <string>
#include <utility>
#include <vector>

namespace dirt {

/// One choice that is varied while all others stay as they are.
struct Sweep {
    std::string name;
    /// The choice's values, and where their settings are in Sweeps::settings.
    std::vector<std::pair<std::string, size_t>> points;
};

/// All sweeps around some settings; settings that several have in common are there once.
struct Sweeps {
    std::vector<RenderSettings> settings; ///< the first are those that the sweeps go around
    std::vector<Sweep> sweeps;
};

/// Tile, bins, both together, view size, traversal, top level, fetch, primary rays, precision,
/// shading, views and bounces, as `bench tradeoff` varies them. View sizes that are absurd for the
/// image are left out.
Sweeps makeSweeps(const RenderSettings& around);

} // namespace dirt
