#pragma once

#include "core/grid/view.h"
#include "core/trace/ray.h"
#include "shaders/shared/border_crossing.h"

#include <glm/vec3.hpp>

namespace dirt {

/// Where a ray is inside one view.
struct ViewSpan : SeenSpan {
    int view = 0;
};

/// A ray in one view's frame, and when it crosses the borders between its tiles.
///
/// With o and d in the view's frame, the plane x = s w is crossed at t = N / D with N = s o_w - o_x
/// and D = d_x - s d_w, at depth w = m_y / D, where m = o × d. The inputs are floats, so N, D and
/// m are exact products with one rounding each: signs are exact, t and w have relative errors of
/// 3 * 2^-53 (of 7 in GLSL, which promises division to 2.5 ulp), whatever the distance to the eye
/// (T2). Seen from the eye the ray is the line
/// m . (x, y, w) = 0; along it x/w grows with the sign of m_y, y/w with that of -m_x.
class ViewRay : public SeenRay {
public:
    ViewRay(const View& view, const Ray& ray);

    /// The part of the ray inside the view's closed cone. False if there is none.
    bool clip(int viewIndex, ViewSpan& span) const;

    const View& view;
};

} // namespace dirt
