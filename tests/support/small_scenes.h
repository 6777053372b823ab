#pragma once

#include "tests/support/nasty_triangles.h"

/// Scenes of a few triangles in the grid frame, small enough for brute force.
namespace dirt::test {

inline glm::vec3 uniformPoint(Random& random, double size) {
    return {(float) random.uniform(-size, size), (float) random.uniform(-size, size),
            (float) random.uniform(-size, size)};
}

/// Triangles of all sizes around the eye.
inline void addSoup(Random& random, std::vector<Triangle>& out, int count) {
    for (int i = 0; i < count; ++i) {
        const glm::vec3 center = uniformPoint(random, 0.9);
        const double size = std::pow(10.0, random.uniform(-4, 0));
        out.push_back({center + uniformPoint(random, size), center + uniformPoint(random, size),
                       center + uniformPoint(random, size)});
    }
}

/// The six walls of a box around the eye, twelve triangles that share their vertices.
inline void addRoom(Random& random, std::vector<Triangle>& out) {
    const glm::vec3 lo = -glm::abs(uniformPoint(random, 1.0)),
                    hi = glm::abs(uniformPoint(random, 1.0));
    for (int axis = 0; axis < 3; ++axis)
        for (float w : {lo[axis], hi[axis]}) {
            glm::vec3 p[4];
            for (int k = 0; k < 4; ++k) {
                p[k][axis] = w;
                p[k][(axis + 1) % 3] = (k & 1 ? hi : lo)[(axis + 1) % 3];
                p[k][(axis + 2) % 3] = (k & 2 ? hi : lo)[(axis + 2) % 3];
            }
            out.push_back({p[0], p[1], p[2]});
            out.push_back({p[3], p[2], p[1]});
        }
}

/// A sphere of quads, closed: neighbours share their vertices, the poles are zero-area triangles.
inline void addSphere(Random& random, std::vector<Triangle>& out, int around, int up) {
    const double pi = 3.14159265358979;
    const glm::dvec3 center(uniformPoint(random, 0.5));
    const double radius = random.uniform(0.05, 1.0);
    const auto point = [&](int i, int j) {
        const double phi = 2 * pi * (i % around) / around, theta = pi * j / up;
        return glm::vec3(center + radius * glm::dvec3(std::sin(theta) * std::cos(phi),
                                                      std::cos(theta),
                                                      std::sin(theta) * std::sin(phi)));
    };
    for (int j = 0; j < up; ++j)
        for (int i = 0; i < around; ++i) {
            out.push_back({point(i, j), point(i + 1, j), point(i + 1, j + 1)});
            out.push_back({point(i, j), point(i + 1, j + 1), point(i, j + 1)});
        }
}

/// A mixture; some triangles occur twice, with the same or turned vertices.
inline std::vector<Triangle> smallScene(Random& random, const ViewSet& set) {
    std::vector<Triangle> triangles;
    const int kinds = random.range(1, 31);
    if (kinds & 1) addSoup(random, triangles, random.range(1, 20));
    if (kinds & 2) addRoom(random, triangles);
    if (kinds & 4) addSphere(random, triangles, random.range(3, 8), random.range(2, 5));
    if (kinds & 24) {
        const std::vector<ViewSet> sets{set};
        NastyTriangles nasty(random, sets);
        for (int i = 0; i < 20; ++i) triangles.push_back(nasty.next().triangle);
    }
    if (random.chance(0.3))
        for (int i = 0; i < 4; ++i) {
            const Triangle t = triangles[random.below((int) triangles.size())];
            triangles.push_back(random.chance(0.5) ? t : Triangle{t.c, t.b, t.a});
        }
    return triangles;
}

} // namespace dirt::test
