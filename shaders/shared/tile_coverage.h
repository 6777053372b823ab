// The two predicates of the overlap test: on which side of a border a direction lies, and whether
// an edge of a triangle leaves a tile out. core/grid/coverage.cpp derives how wrong rounding makes
// them.
#ifndef DIRT_SHARED_TILE_COVERAGE_H
#define DIRT_SHARED_TILE_COVERAGE_H

#include "shaders/shared/rounding.h"

DIRT_SHARED_BEGIN

/// Distance of a direction from the plane of a border, of \p axis 0 (a column's) or 1; negative on
/// the side of small slopes.
DIRT_FUNCTION float borderDistance(vec3 direction, int axis, float slope) {
    DIRT_PRECISE float border = slope * direction.z;
    DIRT_PRECISE float distance = direction[axis] - flushed(border);
    return flushed(distance);
}

/// Whether the plane through the eye and an edge, of inward normal \p n, has no point of the
/// guard-banded tile on its inner side; where the triangle is edge-on, on either side. (A denormal
/// decides nothing here: the largest component of a normal is at least 1/2.)
DIRT_FUNCTION bool edgeSeparates(vec3 n, bool edgeOn, vec2 s, vec2 t) {
    bool right = n.x > 0.0f, below = n.y > 0.0f;
    // The tile's corner farthest inside, then the one farthest outside.
    DIRT_PRECISE float inside = (n.x * (right ? s.y : s.x) + n.y * (below ? t.y : t.x)) + n.z;
    DIRT_PRECISE float outside = (n.x * (right ? s.x : s.y) + n.y * (below ? t.x : t.y)) + n.z;
    return inside < 0.0f || (edgeOn && outside > 0.0f);
}

DIRT_SHARED_END

#endif
