#pragma once

#include "core/grid/settings.h"

#include <vector>

#include <glm/vec3.hpp>

namespace dirt {

/// At most this many tiles along a view: what the margins of coverage are derived for.
inline constexpr int kMaxTiles = 8192;

/// One perspective frustum seen from the eye. Its frame (x, y, w), w along the axis, is a
/// permutation with signs of the grid frame. A tile (column i, row j) is the closed cone
/// { x in [s_i, s_i+1] w, y in [t_j, t_j+1] w, w > 0 }.
struct View {
    int axisX = 0, axisY = 1, axisW = 2; ///< components of the grid frame
    float signW = 1.0f;                  ///< w = signW * p[axisW]

    int width = 0, height = 0; ///< pixels
    int columns = 0, rows = 0; ///< tiles
    std::vector<float> s, t;   ///< border slopes: columns + 1, rows + 1, increasing
    std::vector<float> sLo,
        sHi; ///< guard-banded borders of each column, kGuardBand of a tile wider (Precision::fast:
             ///< none)
    std::vector<float> tLo, tHi; ///< and of each row

    /// (x, y, w) of a point of the grid frame.
    glm::vec3 toView(glm::vec3 p) const { return {p[axisX], p[axisY], signW * p[axisW]}; }
    int tiles() const { return columns * rows; }
};

/// The views of one frame. Full: faces +X -X +Y -Y +Z -Z, for axis a: w = +-p[a], x = p[a+1],
/// y = p[a+2] (indices mod 3). Single: the camera's, whose frame is the grid frame itself.
/// Throws InputError where a view would need more than kMaxTiles tiles a side, and where a number
/// is none that a view can be made of: sizes and bins below 1, or in single mode a field of view
/// that is not between 0 and 180 degrees, or no direction.
std::vector<View> makeViews(const GridSettings& settings, const Camera& camera);

} // namespace dirt
