#pragma once

#include "core/grid/view.h"
#include "core/trace/ray.h"
#include "tests/support/views.h"

#include <cmath>
#include <utility>

namespace dirt::test {

/// A ray beside the line of directions with slope \p border in x (or y, where \p swapped) of \p
/// view: from inside, ever nearer, until it crosses at t = 1 and slope \p y of the other axis. It
/// passes the eye at a distance of 2^\p exponent, so that in double its image is on that line for
/// many rows: |m_y| is 2^(\p exponent - 24) of |m_x|.
inline Ray rayAlong(const View& view, float border, bool swapped, int exponent, float y,
                    float side) {
    const float w = std::ldexp(1.0f, exponent), gap = std::ldexp(1.0f, exponent - 24);
    // x = border (w - gap + gap t), and y = side (1 - t) + w y.
    glm::vec3 origin{border * (w - gap), side + w * y, w}, direction{border * gap, -side, 0.0f};
    if (swapped) {
        std::swap(origin.x, origin.y);
        std::swap(direction.x, direction.y);
    }
    Ray ray;
    for (int i = 0; i < 2; ++i) {
        glm::vec3& p = i ? ray.direction : ray.origin;
        const glm::vec3& q = i ? direction : origin;
        p[view.axisX] = q.x;
        p[view.axisY] = q.y;
        p[view.axisW] = view.signW * q.z;
    }
    return ray;
}

/// Such a ray, and in its way a small triangle.
struct BorderCase {
    ViewSet set;
    Ray ray;
    FrameGeometry geometry;
};

inline BorderCase borderCase(Random& random) {
    BorderCase made{fullViews(random.pick({37, 64, 100}), 1), {}, {}};
    const View& view = made.set.views[(size_t) random.below(6)];
    const int exponent = random.range(-24, -19);
    const bool swapped = random.chance(0.5);
    const float border = (float) random.sign() * random.pick({1.0f, 1.0f, 0.5f});
    const float y = (float) random.range(-3, 3) * 0.25f;
    made.ray = rayAlong(view, border, swapped, exponent, y, (float) random.sign());
    // Some tiles before the border is crossed; across the ray, a fraction of a tile in size.
    const double t = 1.0 - std::pow(2.0, random.uniform(-28, -22));
    const glm::vec3 at(glm::dvec3(made.ray.origin) + glm::dvec3(made.ray.direction) * t);
    const float size = std::ldexp((float) random.uniform(0.1, 1.0), exponent - 9);
    Triangle triangle{at, at, at};
    const int beside = swapped ? view.axisY : view.axisX;
    triangle.a[beside] += size;
    triangle.a[view.axisW] += size;
    triangle.b[beside] -= size;
    triangle.c[view.axisW] -= size;
    made.geometry.triangles = {triangle};
    return made;
}

} // namespace dirt::test
