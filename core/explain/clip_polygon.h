#pragma once

#include "core/grid/clip.h"

#include <vector>

#include <glm/vec3.hpp>

namespace dirt {

/// The part of a triangle in a guard-banded tile: the corners whose depths clipToTile takes the
/// least and the greatest of, in the view's frame (x, y, w), in the order around the polygon; of a
/// triangle without area, along it. Depths are the clip's own; to look at are the other
/// coordinates, good for about 2^-24, and the order. None where clipToTile finds nothing.
std::vector<glm::dvec3> clippedPolygon(const ViewTriangle& triangle, const View& view, int column,
                                       int row);

} // namespace dirt
