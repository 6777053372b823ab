#include "core/path/view_cone.h"

#include <cfloat>
#include <cmath>

#include <gtest/gtest.h>

namespace dirt {
namespace {

/// 90 degrees vertically, twice as wide: |x| <= 2 w, |y| <= w.
ViewCone cone() {
    Camera camera;
    camera.verticalFov = 90.0f;
    return {camera, 200, 100};
}

Ray ray(glm::vec3 origin, glm::vec3 direction) {
    Ray result;
    result.origin = origin;
    result.direction = direction;
    return result;
}

TEST(ViewCone, EndsRaysAtItsSides) {
    const float bound = 8 * 0x1p-24f * 4.0f; // a few roundings of values up to 4
    EXPECT_NEAR(cone().exit(ray({0, 0, 1}, {1, 0, 0})), 2.0f, bound);
    EXPECT_NEAR(cone().exit(ray({0, 0, 1}, {-1, 0, 0})), 2.0f, bound);
    EXPECT_NEAR(cone().exit(ray({0, 0, 1}, {0, 2, 0})), 0.5f, bound);
    EXPECT_NEAR(cone().exit(ray({0, 0, 1}, {0, -2, 0})), 0.5f, bound);
    EXPECT_NEAR(cone().exit(ray({0.5f, 0, 1}, {0, 0, -1})), 0.75f, bound);
    EXPECT_NEAR(cone().exit(ray({0, 0, 3}, {0, 0, -1})), 3.0f, 3 * bound);
}

TEST(ViewCone, RaysInsideNeverEnd) {
    EXPECT_EQ(cone().exit(ray({0.5f, 0.5f, 1}, {1, 0.5f, 1})), FLT_MAX);
    EXPECT_EQ(cone().exit(ray({0, 0, 1}, {0, 0, 1})), FLT_MAX);
}

TEST(ViewCone, RaysFromOutsideEndAtOnceUnlessTheyComeIn) {
    EXPECT_EQ(cone().exit(ray({3, 0, 1}, {1, 0, 0})), 0.0f);
}

} // namespace
} // namespace dirt
