#include "core/trace/view_cone.h"

#include <cfloat>
#include <cmath>

#include <gtest/gtest.h>

namespace dirt {
namespace {

/// 90 degrees vertically, twice as wide: |x| <= 2 w, |y| <= w.
ViewCone cone() {
    Camera camera;
    camera.verticalFov = 90.0f;
    GridSettings settings;
    settings.mode = ViewMode::single;
    settings.width = 200;
    settings.height = 100;
    return ViewCone(makeViews(settings, camera).front());
}

Ray ray(glm::vec3 origin, glm::vec3 direction) {
    Ray result;
    result.origin = origin;
    result.direction = direction;
    return result;
}

TEST(ViewCone, EndsRaysAtItsSides) {
    const float bound = 0x1p-21f * 4.0f; // twice err(t), of values up to 4
    EXPECT_NEAR(cone().part(ray({0, 0, 1}, {1, 0, 0})).end, 2.0f, bound);
    EXPECT_NEAR(cone().part(ray({0, 0, 1}, {-1, 0, 0})).end, 2.0f, bound);
    EXPECT_NEAR(cone().part(ray({0, 0, 1}, {0, 2, 0})).end, 0.5f, bound);
    EXPECT_NEAR(cone().part(ray({0, 0, 1}, {0, -2, 0})).end, 0.5f, bound);
    EXPECT_NEAR(cone().part(ray({0.5f, 0, 1}, {0, 0, -1})).end, 0.75f, bound);
    EXPECT_NEAR(cone().part(ray({0, 0, 3}, {0, 0, -1})).end, 3.0f, 3 * bound);
}

/// Twice err(t) before the border, and behind it where they come in: what a view shows, to the bit.
TEST(ViewCone, EndsAreTwiceAnErrorInside) {
    const double inset = 2 * 1.125 * 0x1p-23;
    const auto end = cone().part(ray({0, 0, 1}, {1, 0, 0})).end;
    EXPECT_LE(end, 2.0 * (1.0 - inset));
    EXPECT_GT(end, 2.0 * (1.0 - inset) - 0x1p-23);
    const auto begin = cone().part(ray({3, 0, 1}, {-1, 0, 0})).begin;
    EXPECT_GE(begin, 1.0 + inset);
    EXPECT_LT(begin, 1.0 + inset + 0x1p-23);
}

TEST(ViewCone, RaysInsideNeverEnd) {
    EXPECT_EQ(cone().part(ray({0.5f, 0.5f, 1}, {1, 0.5f, 1})).end, FLT_MAX);
    EXPECT_EQ(cone().part(ray({0, 0, 1}, {0, 0, 1})).end, FLT_MAX);
}

TEST(ViewCone, RaysFromOutsideEndAtOnceUnlessTheyComeIn) {
    EXPECT_LT(cone().part(ray({3, 0, 1}, {1, 0, 0})).end, 0.0f);
    const ViewCone::Part part = cone().part(ray({3, 0, 1}, {-1, 0, 0}));
    EXPECT_NEAR(part.begin, 1.0f, 0x1p-21f);
    EXPECT_NEAR(part.end, 5.0f, 5 * 0x1p-21f);
    EXPECT_TRUE(part.holds(2.0f));
    EXPECT_FALSE(part.holds(0.9f));
}

} // namespace
} // namespace dirt
