// The parallel transform against core's makeFrameGeometry: the same bits and the same errors.

#include "backend_cpu/thread_pool.h"
#include "core/base/error.h"
#include "core/frame/transform_mesh.h"
#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>

namespace dirt::test {
namespace {

Mesh randomMesh(Random& random, double scale, int triangles) {
    Mesh mesh;
    const int positions = triangles / 2 + 3;
    const auto coordinate = [&] { return (float) (random.uniform(-1, 1) * scale); };
    for (int i = 0; i < positions; ++i)
        mesh.positions.push_back({coordinate(), coordinate(), coordinate()});
    for (int i = 0; i < triangles; ++i) {
        const auto corner = [&] { return (uint32_t) random.below(positions - 1); };
        mesh.triangles.push_back({corner(), corner(), corner()});
    }
    // No triangle refers to the last: it has no part in the scale.
    mesh.positions.back() = glm::vec3(std::numeric_limits<float>::infinity());
    return mesh;
}

TEST(TransformMesh, GivesTheBitsOfTheDefinition) {
    Random random(81);
    ThreadPool one(1), two(2), seven(7);
    FrameGeometry geometry; // the same for all, so that what is left of the last one would show
    for (const double scale : {1e-44, 1e-39, 1e-37, 1e-6, 1.0, 1e6, 1e37})
        for (const int triangles : {1, 1000, 20000}) {
            const Mesh mesh = randomMesh(random, scale, triangles);
            Camera camera;
            camera.eye = {(float) (0.3 * scale), (float) (0.1 * scale), (float) (-0.2 * scale)};
            camera.target = {(float) scale, 0.0f, (float) scale};
            for (const ViewMode mode : {ViewMode::full, ViewMode::single}) {
                const FrameGeometry oracle = makeFrameGeometry(mesh, camera, mode);
                for (ThreadPool* pool : {&one, &two, &seven}) {
                    transformMesh(mesh, camera, mode, *pool, geometry);
                    ASSERT_EQ(geometry.frame.scale, oracle.frame.scale) << scale;
                    ASSERT_EQ(geometry.frame.right, oracle.frame.right);
                    ASSERT_EQ(geometry.triangles.size(), oracle.triangles.size());
                    ASSERT_EQ(std::memcmp(geometry.triangles.data(), oracle.triangles.data(),
                                          oracle.triangles.size() * sizeof(Triangle)),
                              0)
                        << scale << ", " << triangles << " triangles";
                }
            }
        }
}

TEST(TransformMesh, RefusesWhatDoesNotFitFloat) {
    Random random(82);
    ThreadPool pool(2);
    for (const float bad : {std::numeric_limits<float>::infinity(),
                            std::numeric_limits<float>::quiet_NaN(), -3e38f}) {
        Mesh mesh = randomMesh(random, 1.0, 20000);
        mesh.positions[mesh.triangles[12345][1]].y = bad;
        Camera camera;
        camera.eye.y = 3e38f;
        FrameGeometry geometry;
        EXPECT_THROW(makeFrameGeometry(mesh, camera, ViewMode::full), InputError);
        EXPECT_THROW(transformMesh(mesh, camera, ViewMode::full, pool, geometry), InputError);
    }
}

TEST(TransformMesh, TakesNoTriangles) {
    ThreadPool pool(2);
    FrameGeometry geometry;
    geometry.triangles.resize(5);
    transformMesh(Mesh{}, Camera{}, ViewMode::full, pool, geometry);
    EXPECT_TRUE(geometry.triangles.empty());
    EXPECT_EQ(geometry.frame.scale, 1.0f);
}

} // namespace
} // namespace dirt::test
