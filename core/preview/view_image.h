#pragma once

#include "core/grid/view.h"
#include "core/preview/canvas.h"
#include "core/trace/ray.h"

#include <optional>
#include <vector>

#include <glm/vec2.hpp>

namespace dirt {

/// Where a point of a view, as slopes x/w and y/w, lies in tiles.
glm::dvec2 slopesInTiles(const View& view, glm::dvec2 slopes);

/// Where the image of a point of the grid frame lies in a view, in tiles: (0, 0) is the corner of
/// the first one. None where the point is not before the eye.
std::optional<glm::dvec2> inTiles(const View& view, glm::dvec3 point);

/// The image of the part of a ray from t = \p begin to \p end (which may be infinite), in tiles:
/// points that lines connect, in the ray's order. One alone where the ray is seen end on. None
/// where no point of the part is before the eye.
std::vector<glm::dvec2> imageOf(const View& view, const Ray& ray, double begin, double end);

/// Tiles of a view as they stand in a picture: all of them or some, each of several pixels, or
/// several of them in one.
struct ViewWindow {
    int column = 0, row = 0;   ///< of the first tile that is shown
    int columns = 0, rows = 0; ///< that are shown
    int enlarged = 1;          ///< pixels along a tile
    int reduced = 1;           ///< tiles along a pixel; one of the two is 1
    int left = 0, top = 0;     ///< of the picture's pixels

    int width() const { return (columns * enlarged + reduced - 1) / reduced; }
    int height() const { return (rows * enlarged + reduced - 1) / reduced; }
    Box box() const { return {left, top, width(), height()}; }

    /// Where a point in tiles stands.
    glm::dvec2 at(glm::dvec2 tiles) const;
    /// The pixels of a cell of level \p level of the pyramid, at least one.
    Box cell(int level, int cellColumn, int cellRow) const;
};

/// All tiles of a view, \p enlarged times.
ViewWindow wholeView(const View& view, int enlarged);

} // namespace dirt
