#pragma once

#include "core/grid/geometry.h"
#include "core/trace/ray.h"

namespace dirt {

/// What double arithmetic can say of a ray and a triangle.
struct FilterResult {
    /// False: the exact ray does not meet the closed triangle.
    bool possible = false;
    /// Where it is possible: an interval that contains the exact t.
    double tLow = 0.0, tHigh = 0.0;
};

/// The filter before exact arithmetic: never refuses a triangle that is hit.
FilterResult filterTriangle(const Ray& ray, const Triangle& triangle);

} // namespace dirt
