#pragma once

#include "core/path/fetch_surface.h"
#include "tests/support/small_scenes.h"

#include <cstring>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace dirt::test {

inline bool sameBits(const SurfacePoint& a, const SurfacePoint& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

inline size_t countDifferent(const std::vector<SurfacePoint>& a,
                             const std::vector<SurfacePoint>& b) {
    EXPECT_EQ(a.size(), b.size());
    size_t different = 0;
    for (size_t i = 0; i < a.size(); ++i) different += !sameBits(a[i], b[i]);
    return different;
}

inline size_t countFound(const std::vector<SurfacePoint>& points) {
    size_t found = 0;
    for (const SurfacePoint& point : points) found += point.found();
    return found;
}

/// Not near zero.
inline glm::vec3 randomDirection(Random& random) {
    glm::vec3 d;
    do d = uniformPoint(random, 1.0);
    while (glm::dot(d, d) < 0.01f);
    return d;
}

} // namespace dirt::test
