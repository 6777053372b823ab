#pragma once

#include "tests/support/border_rays.h"

#include <algorithm>
#include <vector>

namespace dirt::test {

/// A ray that passes close to the eye, and two small triangles in its way, one a little before and
/// one a little behind the border of a tile: at parameters that round to the same float, or the
/// second to the lower one. So what a search finds first is not the nearest hit, nor the one with
/// the lowest id; and near the eye, where the ray's slope runs fast, the second triangle is in no
/// list of the first tile, however near it is.
struct FinalCase {
    ViewSet set;
    Ray ray;
    FrameGeometry geometry;
};

inline FinalCase finalCase(Random& random) {
    FinalCase made{fullViews(random.pick({37, 64, 100}), 1), {}, {}};
    made.set.settings.bins = random.pick({1, 16});
    const View& view = made.set.views[(size_t) random.below(6)];
    // From far away past the eye, at depths of about 2^-12 to 2^-20.
    const double w = std::ldexp(random.uniform(1, 2), -random.range(12, 20));
    const double s = view.s[(size_t) random.range(1, view.columns - 1)];
    const bool along = random.chance(0.5);
    const glm::dvec3 at(s * w, random.uniform(-0.9, 0.9) * w, w);
    glm::dvec3 step(random.sign() * random.uniform(0.5, 1), random.uniform(-0.01, 0.01),
                    along ? random.uniform(-0.5, 0.5) : 0.0);
    const double t = random.uniform(1, 2);
    made.ray.origin = fromView(view, glm::vec3(at - step * t));
    made.ray.direction = fromView(view, glm::vec3(step));
    // Where the ray, as rounded, crosses the border.
    const glm::dvec3 o(view.toView(made.ray.origin)), d(view.toView(made.ray.direction));
    const double crossing = (s * o.z - o.x) / (d.x - s * d.z);
    for (const double side : {-1.0, 1.0}) {
        const double beside = crossing * (1.0 + side * std::exp2(random.uniform(-27, -23)));
        const glm::dvec3 p = o + d * beside;
        // Across the ray, far smaller than its way from the border.
        const double size = std::abs(beside - crossing) * 0.01;
        const auto corner = [&](double y, double z) {
            return fromView(view, glm::vec3(p + size * glm::dvec3(0.0, y, z)));
        };
        made.geometry.triangles.push_back({corner(-1, -1), corner(1, -1), corner(0, 1)});
    }
    if (random.chance(0.7)) std::swap(made.geometry.triangles[0], made.geometry.triangles[1]);
    return made;
}

/// A ray that crosses the border of a tile, and a triangle across it a little behind the border, by
/// some roundings of t; the tile before lists it in its guard band.
struct FiledCase {
    ViewSet set;
    Ray ray;
    FrameGeometry geometry;
    double border;      ///< t there, but for 2^-51
    int before, behind; ///< tiles of the first view

    /// The tile that a hit at \p t is filed under: that before, as long as t - err(t) is in it.
    int tileOf(float t) const { return t * (1.0 - 1.125 * 0x1p-23) <= border ? before : behind; }
};

inline FiledCase filedCase(Random& random) {
    FiledCase made{fullViews(random.pick({37, 64, 100}), 1), {}, {}, 0.0, 0, 0};
    const View& view = made.set.views[0];
    const int border = random.range(view.columns / 4, view.columns * 3 / 4);
    const int row = random.range(view.rows / 4, view.rows * 3 / 4);
    const double s = view.s[(size_t) border];
    const float w = (float) random.uniform(0.3, 0.6);
    const float y = (float) (0.5 * (view.t[(size_t) row] + view.t[(size_t) row + 1]) * w);
    const bool up = random.chance(0.5);
    const float step = (up ? 1.0f : -1.0f) * (float) random.uniform(0.5, 0.6);
    const float x = (float) (s * w - step * random.uniform(1, 2));
    made.ray = {fromView(view, {x, y, w}), fromView(view, {step, 0.0f, 0.0f}), kNoPrimitive};
    made.border = (s * w - x) / step;
    const float at =
        (float) (x + step * made.border * (1.0 + std::exp2(random.uniform(-25, -22.5))));
    const float size = 0.1f * w / (float) view.rows;
    made.geometry.triangles = {{fromView(view, {at, y - size, w - size}),
                                fromView(view, {at, y + size, w - size}),
                                fromView(view, {at, y, w + size})}};
    made.before = row * view.columns + (up ? border - 1 : border);
    made.behind = row * view.columns + (up ? border : border - 1);
    return made;
}

} // namespace dirt::test
