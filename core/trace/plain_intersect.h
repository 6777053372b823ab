#pragma once

#include "core/trace/intersect.h"

namespace dirt {

/// The test of `--precision fast`: the edge functions of the triangle as the ray sees it, in float,
/// without bounds or a second opinion (Woop, Benthin, Wald, "Watertight Ray/Triangle Intersection",
/// 2013, without its fallback). Neighbours agree about their common edge, but not with the exact
/// ray; nor do the lists, which are bounded from the eye. Does not look at ray.skip.
bool plainIntersect(const Ray& ray, const Triangle& triangle, TriangleHit& out);

} // namespace dirt
