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

} // namespace dirt::test
