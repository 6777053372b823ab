#pragma once

#include <algorithm>
#include <cmath>

namespace dirt::generate {

/// How finely parts are tessellated. A quality of 1 is the look aimed at; edges shrink and small
/// things multiply in proportion to it.
struct Detail {
    double quality = 1;
    bool countOnly = false; ///< meshes count their triangles and store nothing

    /// Number of steps where quality 1 takes `ideal`.
    int steps(double ideal, int minimum = 1) const {
        return std::max(minimum, static_cast<int>(std::lround(ideal * quality)));
    }

    /// Number of small things (leaves, balusters): grows in proportion up to `ideal`, then, if at
    /// all, slowly.
    int number(double ideal, int minimum = 1, double growth = 0) const {
        const double factor = quality < 1 ? quality : std::pow(quality, growth);
        return std::max(minimum, static_cast<int>(std::lround(ideal * factor)));
    }

    /// Whether an ornament that appears from quality `threshold` on is there.
    bool shows(double threshold) const { return quality >= threshold; }
};

} // namespace dirt::generate
