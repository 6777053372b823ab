#include "core/scene/animation.h"
#include "tests/scene/apply.h"

#include <gtest/gtest.h>

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

namespace dirt {
namespace {

/// A motion that stands still.
TransformMotion rest() {
    TransformMotion motion;
    motion.scale.keys = {{0.0, glm::dvec3(1.0)}};
    motion.rotation.keys = {{0.0, Rotation{}}};
    motion.translation.keys = {{0.0, glm::dvec3(0.0)}};
    return motion;
}

Animation oneSpace(TransformMotion motion) {
    Animation animation;
    animation.spaces.push_back({MovingSpace::kWorld, glm::dmat4(1.0), std::move(motion)});
    return animation;
}

/// Two products and a sum of numbers of at most 4, in double.
constexpr double kRounding = 8 * 0x1p-52;

TEST(Animation, HoldsOutsideTheKeysAndIsLinearBetween) {
    TransformMotion motion = rest();
    motion.translation.keys = {{1.0, {0, 0, 0}}, {2.0, {4, 0, 0}}, {4.0, {4, 2, 0}}};
    motion.scale.keys = {{1.0, {1, 1, 1}}, {3.0, {3, 1, 1}}};
    const Animation animation = oneSpace(motion);
    const auto place = [&](double time) {
        return test::apply(animation.toWorld(0, time), glm::dvec3(0.0));
    };
    EXPECT_EQ(place(0.0), glm::dvec3(0, 0, 0));
    EXPECT_EQ(place(1.0), glm::dvec3(0, 0, 0));
    EXPECT_EQ(place(1.25), glm::dvec3(1, 0, 0));
    EXPECT_EQ(place(2.0), glm::dvec3(4, 0, 0));
    EXPECT_EQ(place(3.0), glm::dvec3(4, 1, 0));
    EXPECT_EQ(place(4.0), glm::dvec3(4, 2, 0));
    EXPECT_EQ(place(1e6), glm::dvec3(4, 2, 0));
    const auto width = [&](double time) {
        return test::apply(animation.toWorld(0, time), {1, 0, 0}).x - place(time).x;
    };
    EXPECT_EQ(width(0.0), 1.0);
    EXPECT_EQ(width(2.0), 2.0);
    EXPECT_EQ(width(9.0), 3.0);
}

TEST(Animation, TurnsEvenlyAboutOneAxis) {
    // From one orientation to another about neither one's axis: the way is a turn about a fixed
    // axis, of which equal times take equal parts.
    TransformMotion motion = rest();
    const Rotation first{50, {1, 2, 3}}, second{-70, {2, -1, 0.5}};
    motion.rotation.keys = {{0.0, first}, {4.0, second}};
    const Animation animation = oneSpace(motion);
    const auto at = [&](double time) { return glm::dmat3(animation.toWorld(0, time)); };
    EXPECT_EQ(at(0.0), rotationMatrix(first));
    EXPECT_EQ(at(4.0), rotationMatrix(second));
    const glm::dmat3 step = at(1.0) * glm::transpose(at(0.0));
    for (int i = 1; i < 4; ++i) {
        const glm::dmat3 again = at(i + 1.0) * glm::transpose(at(i));
        for (int c = 0; c < 3; ++c)
            // Sines, cosines and an arc cosine, each right to some ulp, of numbers up to 1.
            EXPECT_LT(glm::length(again[c] - step[c]), 64 * 0x1p-52) << i;
    }
    // Half of a quarter turn is an eighth.
    motion.rotation.keys = {{0.0, {0, {0, 1, 0}}}, {1.0, {90, {0, 1, 0}}}};
    const glm::dvec3 p = test::apply(oneSpace(motion).toWorld(0, 0.5), {1, 0, 0});
    EXPECT_LT(glm::length(p - glm::dvec3(std::sqrt(0.5), 0, -std::sqrt(0.5))), kRounding);
}

TEST(Animation, TakesTheShorterWayRound) {
    TransformMotion motion = rest();
    motion.rotation.keys = {{0.0, {0, {0, 1, 0}}}, {1.0, {270, {0, 1, 0}}}};
    const glm::dvec3 p = test::apply(oneSpace(motion).toWorld(0, 0.5), {1, 0, 0});
    EXPECT_LT(glm::length(p - glm::dvec3(std::sqrt(0.5), 0, std::sqrt(0.5))), kRounding);
}

TEST(Animation, SpacesLieInSpaces) {
    Animation animation;
    TransformMotion outer = rest(), inner = rest();
    outer.rotation.keys = {{0.0, {90, {0, 0, 1}}}};
    inner.translation.keys = {{0.0, {0, 0, 0}}, {1.0, {2, 0, 0}}};
    const glm::dmat4 between = placement({2, 2, 2}, glm::dmat3(1.0), {0, 1, 0});
    animation.spaces = {
        {MovingSpace::kWorld, placement({1, 1, 1}, glm::dmat3(1.0), {10, 0, 0}), outer},
        {0, between, inner}};
    // (1, 0, 0) moves to (3, 0, 0), is doubled and lifted to (6, 1, 0), turned to (-1, 6, 0),
    // moved.
    EXPECT_EQ(test::apply(animation.toWorld(1, 1.0), {1, 0, 0}), glm::dvec3(9, 6, 0));
}

TEST(Animation, MovesWhatTheCameraHasKeysFor) {
    Animation animation;
    animation.camera.emplace();
    animation.camera->eye.keys = {{0.0, {0, 0, 5}}, {1.0, {2, 0, 5}}};
    animation.camera->verticalFov.keys = {{0.0, 20.0}, {2.0, 40.0}};
    Camera camera;
    camera.target = {7, 8, 9};
    const Camera moved = animation.cameraAt(camera, 0.5);
    EXPECT_EQ(moved.eye, glm::vec3(1, 0, 5));
    EXPECT_EQ(moved.target, camera.target);
    EXPECT_EQ(moved.up, camera.up);
    EXPECT_EQ(moved.verticalFov, 25.0f);
    EXPECT_EQ(Animation().cameraAt(camera, 1.0).eye, camera.eye);
}

TEST(Animation, FramesMeetTheKeysInSeconds) {
    Animation animation;
    animation.fps = 30.0;
    EXPECT_EQ(animation.timeOf(3), 0.1); // both are the double nearest to a tenth
    EXPECT_EQ(animation.lastFrame(), 0);
    TransformMotion motion = rest();
    motion.scale.keys.push_back({2.01, glm::dvec3(2.0)});
    animation.spaces.push_back({MovingSpace::kWorld, glm::dmat4(1.0), motion});
    EXPECT_EQ(animation.lastFrame(), 61);
}

} // namespace
} // namespace dirt
