#pragma once

#include <algorithm>
#include <cmath>

namespace dirt::generate {

/// How finely parts are tessellated: edges shrink in proportion to the quality. At 1 nothing looks
/// faceted from a step away (the atrium has about a million triangles); from 0.5 on all ornament
/// is there; below that it goes piece by piece, so that the count falls smoothly.
struct Detail {
    double quality = 1;
    bool countOnly = false; ///< meshes count their triangles and store nothing

    /// Number of steps where quality 1 takes `ideal`.
    int steps(double ideal, int minimum = 1) const {
        return std::max(minimum, static_cast<int>(std::lround(ideal * quality)));
    }

    /// Number of small things (leaves, balusters): all of them from quality 0.4 on; beyond 1 it
    /// grows with the given power.
    int number(double ideal, int minimum = 1, double growth = 0) const {
        const double factor =
            quality < 1 ? std::min(1.0, 2.5 * quality) : std::pow(quality, growth);
        return std::max(minimum, static_cast<int>(std::lround(ideal * factor)));
    }

    /// Whether an ornament that appears from quality `threshold` on is there.
    bool shows(double threshold) const { return quality >= threshold; }
};

} // namespace dirt::generate
