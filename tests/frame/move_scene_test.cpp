#include "core/frame/move_scene.h"

#include "backend_cpu/thread_pool.h"
#include "core/base/error.h"
#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <new>

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

namespace {
std::atomic<size_t> allocations{0};
} // namespace

[[gnu::noinline]] void* operator new(size_t bytes) {
    ++allocations;
    if (void* memory = std::malloc(bytes)) return memory;
    throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
    std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, size_t) noexcept {
    std::free(memory);
}

namespace dirt {
namespace {

glm::dvec3 randomPoint(test::Random& random) {
    return {random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-3, 3)};
}

Rotation randomRotation(test::Random& random) {
    return {random.uniform(-170, 170), randomPoint(random)};
}

/// Vertices in two spaces, the second within the first, and some that stand still; more than the
/// threads take in one piece.
Scene randomScene(test::Random& random) {
    Scene scene;
    Animation& animation = scene.animation;
    for (uint32_t space = 0; space < 2; ++space) {
        MovingSpace& moving = animation.spaces.emplace_back();
        moving.parent = space == 0 ? MovingSpace::kWorld : 0;
        moving.toParent = placement(glm::dvec3(1, 2, 0.5), rotationMatrix(randomRotation(random)),
                                    randomPoint(random));
        for (double time : {0.1, 0.8, 2.0}) {
            moving.motion.scale.keys.push_back(
                {time, glm::dvec3(0.2) + glm::abs(randomPoint(random))});
            moving.motion.rotation.keys.push_back({time, randomRotation(random)});
            moving.motion.translation.keys.push_back({time, randomPoint(random)});
        }
    }
    animation.camera.emplace();
    animation.camera->eye.keys = {{0.0, {0, 0, 9}}, {2.0, {1, 2, 9}}};
    for (uint32_t space = 0; space < 2; ++space) {
        scene.mesh.positions.emplace_back(7.0f);
        scene.mesh.normals.emplace_back(0.0f, 1.0f, 0.0f);
        MovingPart& part = animation.parts.emplace_back();
        part.space = space;
        part.firstPosition = scene.mesh.positions.size();
        part.firstNormal = scene.mesh.normals.size();
        for (int i = 0; i < 20'000; ++i) {
            part.positions.emplace_back(randomPoint(random));
            part.normals.emplace_back(glm::normalize(randomPoint(random)));
        }
        scene.mesh.positions.resize(part.firstPosition + part.positions.size());
        scene.mesh.normals.resize(part.firstNormal + part.normals.size());
    }
    return scene;
}

template <typename Vector>
bool sameBits(const std::vector<Vector>& a, const std::vector<Vector>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Vector)) == 0;
}

TEST(MoveScene, AFrameIsTheSameFromWhereverItIsReached) {
    test::Random random(1);
    Scene forward = randomScene(random), single = forward;
    SerialExecutor serial;
    ThreadPool threads(3);
    for (int frame = 0; frame < 60; ++frame) {
        moveScene(forward, frame, threads); // through all frames, on threads
        Scene direct = single;              // and from the start, serially
        moveScene(direct, frame, serial);
        ASSERT_TRUE(sameBits(forward.mesh.positions, direct.mesh.positions)) << frame;
        ASSERT_TRUE(sameBits(forward.mesh.normals, direct.mesh.normals)) << frame;
        ASSERT_EQ(forward.camera.eye, direct.camera.eye);
    }
    moveScene(forward, 7, threads); // and backwards
    moveScene(single, 7, serial);
    EXPECT_TRUE(sameBits(forward.mesh.positions, single.mesh.positions));
    EXPECT_EQ(forward.mesh.positions[0], glm::vec3(7.0f)) << "what stands still, stands still";
    EXPECT_EQ(forward.mesh.positions[20'001], glm::vec3(7.0f));
}

TEST(MoveScene, RoundsByAFewUlp) {
    test::Random random(2);
    Scene scene = randomScene(random);
    SerialExecutor serial;
    moveScene(scene, 17, serial);
    for (const MovingPart& part : scene.animation.parts) {
        const glm::dmat4 exact = scene.animation.toWorld(part.space, 17 / 25.0);
        const glm::dmat3 linear(exact);
        for (size_t i = 0; i < part.positions.size(); ++i) {
            const glm::dvec3 p(part.positions[i]);
            const glm::dvec3 truth(exact * glm::dvec4(p, 1.0));
            for (int k = 0; k < 3; ++k) {
                // Each term carries the matrix entry's rounding, the product's and at most three
                // sums': 5 times 2^-24, and second orders below another.
                const double terms = std::abs(exact[0][k] * p.x) + std::abs(exact[1][k] * p.y) +
                                     std::abs(exact[2][k] * p.z) + std::abs(exact[3][k]);
                ASSERT_LE(std::abs(scene.mesh.positions[part.firstPosition + i][k] - truth[k]),
                          6 * 0x1p-24 * terms);
            }
            // A normal stays perpendicular to its surface, of whatever directions that is made.
            const glm::dvec3 n(part.normals[i]);
            const glm::dvec3 across =
                glm::cross(n, std::abs(n.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0));
            const glm::dvec3 moved(scene.mesh.normals[part.firstNormal + i]);
            ASSERT_NEAR(glm::length(moved), 1.0, 0x1p-23); // components right to half an ulp
            // As stored, n and moved are rounded: across is exactly perpendicular to n, moved to
            // its image but for half an ulp of each component.
            ASSERT_LE(std::abs(glm::dot(moved, linear * across)),
                      2 * 0x1p-24 * glm::length(linear * across));
            ASSERT_GT(glm::dot(moved, linear * n), 0.0);
        }
    }
}

TEST(MoveScene, AllocatesNothing) {
    test::Random random(3);
    Scene scene = randomScene(random);
    ThreadPool threads(2);
    moveScene(scene, 0, threads);
    const size_t before = allocations;
    for (int frame = 1; frame < 20; ++frame) moveScene(scene, frame, threads);
    EXPECT_EQ(allocations, before);
}

TEST(MoveScene, RefusesVerticesBeyondFloat32) {
    test::Random random(4);
    Scene scene = randomScene(random);
    scene.animation.spaces[1].motion.scale.keys.push_back({4.0, glm::dvec3(1e38)});
    SerialExecutor serial;
    moveScene(scene, 50, serial);
    try {
        moveScene(scene, 100, serial);
        FAIL() << "no error";
    } catch (const InputError& error) {
        EXPECT_STREQ(error.what(), "frame 100: a vertex that moves does not fit in float32");
    }
}

TEST(MoveScene, AFlattenedSpaceHasNoNormals) {
    test::Random random(5);
    Scene scene = randomScene(random);
    scene.animation.spaces[0].motion.scale.keys = {{0.0, glm::dvec3(0.0)}};
    SerialExecutor serial;
    moveScene(scene, 0, serial);
    EXPECT_EQ(scene.mesh.normals.back(), glm::vec3(0.0f));
}

} // namespace
} // namespace dirt
