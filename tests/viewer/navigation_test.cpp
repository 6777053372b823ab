// How the viewer's camera moves and turns, and what its error estimate says of samples that are
// known.

#include "app/viewer/navigation.h"

#include "app/viewer/error_estimate.h"

#include <cmath>
#include <numbers>
#include <random>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace dirt {
namespace {

Camera camera() {
    Camera camera;
    camera.eye = {1.0f, 2.0f, 3.0f};
    camera.target = {1.0f, 2.0f, -1.0f};
    return camera;
}

/// Some roundings of coordinates up to 8.
constexpr float kNear = 1e-5f;

void expectNear(glm::vec3 a, glm::vec3 b) {
    EXPECT_LT(glm::length(a - b), kNear) << a.x << " " << a.y << " " << a.z;
}

TEST(Navigation, MovesAlongTheView) {
    Camera c = camera();
    moveCamera(c, 2, 0, 0);
    expectNear(c.eye, {1, 2, 1});
    expectNear(c.target, {1, 2, -3});
    moveCamera(c, 0, 1, 0);
    expectNear(c.eye, {2, 2, 1});
    moveCamera(c, 0, 0, -1);
    expectNear(c.eye, {2, 1, 1});
}

TEST(Navigation, TurnsToTheRightAndBack) {
    Camera c = camera();
    turnCamera(c, std::numbers::pi / 2, 0);
    expectNear(c.target, {5, 2, 3});
    for (int i = 0; i < 3; ++i) turnCamera(c, std::numbers::pi / 2, 0);
    expectNear(c.target, camera().target);
}

TEST(Navigation, NeverLooksAlongTheUpDirection) {
    Camera c = camera();
    for (int i = 0; i < 100; ++i) turnCamera(c, 0, 0.1);
    const glm::vec3 way = glm::normalize(c.target - c.eye);
    EXPECT_GT(way.y, 0.99f);
    EXPECT_LT(way.y, 0.9999f);
    EXPECT_LT(way.z, 0.0f); // and not backwards
    for (int i = 0; i < 100; ++i) turnCamera(c, 0.3, -0.1);
    EXPECT_LT(glm::normalize(c.target - c.eye).y, -0.99f);
}

TEST(Navigation, AMoveBelowRoundingDoesNotTurn) {
    Camera c;
    c.eye = {1e6f, 0.0f, 0.0f};
    c.target = {1e6f, 0.0f, -1.0f};
    for (int i = 0; i < 100; ++i) moveCamera(c, 0, 0.01, 0); // an ulp is 0.0625
    expectNear(c.target - c.eye, {0, 0, -1});
}

TEST(ErrorEstimate, IsTheDeviationOfTheMean) {
    std::mt19937 generator(1);
    std::normal_distribution<float> samples(2.0f, 0.5f);
    constexpr int kPixels = 10000, kSamples = 25;
    ErrorEstimate estimate;
    EXPECT_EQ(estimate.relative(), 0.0);
    std::vector<double> sums(kPixels, 0.0);
    for (int n = 1; n <= kSamples; ++n) {
        Image mean{kPixels, 1, std::vector<glm::vec3>(kPixels)};
        for (int i = 0; i < kPixels; ++i) {
            sums[(size_t) i] += samples(generator);
            mean.pixels[(size_t) i] = glm::vec3((float) (sums[(size_t) i] / n));
        }
        estimate.add(mean);
    }
    // 0.5 / sqrt(25) / 2; of 10,000 pixels' variances, each known to 29 %, the mean is to 0.3 %.
    EXPECT_NEAR(estimate.relative(), 0.05, 0.05 * 0.01);
}

} // namespace
} // namespace dirt
