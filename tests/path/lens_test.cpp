#include "core/path/camera_rays.h"
#include "tests/support/random.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace dirt {
namespace {

Camera camera() {
    Camera camera;
    camera.eye = {1, 2, 3};
    camera.target = {4, 1, -2};
    camera.apertureRadius = 0.25f;
    camera.focalDistance = 6.0f;
    return camera;
}

TEST(Lens, RaysOfAPointCrossInTheFocalPlane) {
    test::Random random(1);
    for (ViewMode mode : {ViewMode::full, ViewMode::single})
        for (float scale : {1.0f, 0.125f}) {
            const CameraRays rays(camera(), 64, 32, mode, scale);
            for (int i = 0; i < 1000; ++i) {
                const float x = (float) random.uniform(0, 64), y = (float) random.uniform(0, 32);
                const Ray pinhole = rays.through(x, y);
                const Ray ray =
                    rays.through(x, y, (float) random.uniform(), (float) random.uniform());
                // Directions have the length 1 along the view, so both are in the plane there.
                const float t = 6.0f * scale;
                const glm::vec3 apart = ray.origin + t * ray.direction - t * pinhole.direction;
                EXPECT_LT(glm::length(apart), 1e-6f * t); // half a dozen roundings
                EXPECT_LE(glm::length(ray.origin), 0.25f * scale * (1.0f + 1e-6f));
                EXPECT_NEAR(glm::dot(ray.origin, rays.plane().forward), 0.0f, 1e-7f);
            }
        }
}

TEST(Lens, IsPassedEverywhereAlike) {
    const CameraRays rays(camera(), 64, 32, ViewMode::single);
    test::Random random(2);
    // Four rings of one area and four quadrants.
    int counts[4][4] = {};
    const int drawn = 16'000;
    for (int i = 0; i < drawn; ++i) {
        const Ray ray = rays.through(10, 10, (float) random.uniform(), (float) random.uniform());
        const float part = glm::dot(ray.origin, ray.origin) / (0.25f * 0.25f);
        ++counts[std::min((int) (part * 4.0f), 3)]
                [(ray.origin.x > 0.0f ? 1 : 0) + (ray.origin.y > 0.0f ? 2 : 0)];
    }
    // Five standard deviations of a count around 1,000.
    for (const auto& ring : counts)
        for (int count : ring) EXPECT_NEAR(count, drawn / 16, 5.0 * std::sqrt(drawn / 16.0));
}

TEST(Lens, APinholeIsTheEye) {
    Camera sharp = camera();
    sharp.apertureRadius = 0.0f;
    const CameraRays rays(sharp, 64, 32, ViewMode::full);
    const Ray ray = rays.through(7, 9, 0.3f, 0.7f), pinhole = rays.through(7, 9);
    EXPECT_EQ(ray.origin, glm::vec3(0.0f));
    EXPECT_EQ(ray.direction, pinhole.direction);
}

} // namespace
} // namespace dirt
