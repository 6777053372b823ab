#pragma once

#include "core/grid/view.h"
#include "core/trace/ray.h"
#include "shaders/shared/margins.h"

#include <glm/vec3.hpp>

namespace dirt {

/// Where a ray is inside one view: parameters [begin, end], rounded outwards.
struct ViewSpan {
    int view = 0;
    double begin = 0.0, end = 0.0;
    double depth = 0.0; ///< w at begin
};

/// A ray in one view's frame, and when it crosses the borders between its tiles.
///
/// With o and d in the view's frame, the plane x = s w is crossed at t = N / D with N = s o_w - o_x
/// and D = d_x - s d_w, at depth w = m_y / D, where m = o × d. The inputs are floats, so N, D and
/// m are exact products with one rounding each: signs are exact, t and w have relative errors of
/// 3 * 2^-53 (of 7 in GLSL, which promises division to 2.5 ulp), whatever the distance to the eye
/// (T2). Seen from the eye the ray is the line
/// m . (x, y, w) = 0; along it x/w grows with the sign of m_y, y/w with that of -m_x.
class ViewRay {
public:
    ViewRay(const View& view, const Ray& ray);

    /// The part of the ray inside the view's closed cone. False if there is none.
    bool clip(int viewIndex, ViewSpan& span) const;

    /// When and where a border is crossed; t is +-infinity if that never happens (the crossing
    /// would lie behind the eye): + if the border is still ahead forever, - if always behind.
    struct Crossing {
        double t, depth;
        bool valid;
    };
    Crossing column(float s) const { return crossing(0, s); }
    Crossing row(float t) const { return crossing(1, t); }

    /// Whether the crossing of column border s comes before (1) or after (-1) that of row border t,
    /// or too close to tell (0): the side on which the tile corner lies of the ray's image.
    int order(float s, float t) const;

    const View& view;
    glm::dvec3 origin, direction, moment;
    int stepX, stepY; ///< -1, 0, 1: how x/w and y/w change along the ray

private:
    Crossing crossing(int axis, double slope) const;
    bool clipSide(int axis, double slope, bool isLow, ViewSpan& span) const;
};

} // namespace dirt
