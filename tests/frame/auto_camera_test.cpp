#include "core/frame/auto_camera.h"

#include "backend_cpu/cpu_backend.h"
#include "core/trace/traverse.h"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace dirt {
namespace {

void addQuad(Mesh& mesh, glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec3 d) {
    const uint32_t first = (uint32_t) mesh.positions.size();
    mesh.positions.insert(mesh.positions.end(), {a, b, c, d});
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.triangles.push_back({first, first + 2, first + 3});
}

/// A box whose faces look outwards, or inwards.
void addBox(Mesh& mesh, glm::vec3 low, glm::vec3 high, bool inwards) {
    for (int axis = 0; axis < 3; ++axis)
        for (int side = 0; side < 2; ++side) {
            const int u = (axis + 1) % 3, v = (axis + 2) % 3;
            glm::vec3 corner[4];
            for (int i = 0; i < 4; ++i) {
                corner[i][axis] = side ? high[axis] : low[axis];
                corner[i][u] = i == 1 || i == 2 ? high[u] : low[u];
                corner[i][v] = i >= 2 ? high[v] : low[v];
            }
            if ((side == 1) != inwards)
                addQuad(mesh, corner[0], corner[1], corner[2], corner[3]);
            else
                addQuad(mesh, corner[3], corner[2], corner[1], corner[0]);
        }
}

/// A hall of 20 x 6 x 10 with four pillars.
Mesh hall() {
    Mesh mesh;
    addBox(mesh, {-10, 0, -5}, {10, 6, 5}, true);
    for (float x : {-6.0f, 6.0f})
        for (float z : {-3.0f, 3.0f})
            addBox(mesh, {x - 0.4f, 0, z - 0.4f}, {x + 0.4f, 6, z + 0.4f}, false);
    return mesh;
}

Mesh ball() {
    Mesh mesh;
    const auto at = [](int i, int j) {
        const double theta = std::numbers::pi * i / 24, phi = std::numbers::pi * j / 24;
        return glm::vec3(std::sin(theta) * std::sin(phi), std::cos(theta),
                         std::sin(theta) * std::cos(phi));
    };
    for (int i = 0; i < 24; ++i)
        for (int j = 0; j < 48; ++j)
            addQuad(mesh, at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
    return mesh;
}

Mesh scaled(Mesh mesh, float scale) {
    for (glm::vec3& p : mesh.positions) p *= scale;
    return mesh;
}

Standpoint choose(const Mesh& mesh, const CameraHints& hints = {}) {
    SerialExecutor executor;
    CpuBackend backend(executor);
    return chooseStandpoint(mesh, backend, hints);
}

bool showsSomething(const Mesh& mesh, const Camera& camera) {
    const FrameGeometry geometry = makeFrameGeometry(mesh, camera, ViewMode::full);
    Ray ray;
    ray.direction = cameraBasis(camera).forward;
    return closestHitBruteForce(geometry, ray).found();
}

TEST(AutoCamera, StandsInARoom) {
    const Mesh mesh = hall();
    const Camera camera = choose(mesh).camera;
    EXPECT_LT(std::abs(camera.eye.x), 10.0f);
    EXPECT_LT(std::abs(camera.eye.z), 5.0f);
    EXPECT_GT(camera.eye.y, 0.0f);
    EXPECT_LT(camera.eye.y, 6.0f);
    // Along the hall rather than at the nearest wall.
    const glm::vec3 forward = cameraBasis(camera).forward;
    EXPECT_GT(std::abs(forward.x), std::abs(forward.z));
}

TEST(AutoCamera, StandsOutsideOfASolid) {
    const Mesh mesh = ball();
    const Camera camera = choose(mesh).camera;
    EXPECT_GT(glm::length(camera.eye), 1.2f);
    EXPECT_LT(glm::length(camera.eye), 8.0f);
    EXPECT_TRUE(showsSomething(mesh, camera));
}

/// A slab that is bare on one side, which at a slant is as deep as the other, where towers stand.
TEST(AutoCamera, PrefersWhatIsThereToABareWall) {
    Mesh mesh;
    addBox(mesh, {-10, -12, -0.2f}, {10, 12, 0}, false);
    for (int i = -8; i <= 8; i += 4)
        addBox(mesh, {(float) i - 1, (float) i - 3, 0}, {(float) i + 1, (float) i + 3, 8}, false);
    const Camera camera = choose(mesh).camera;
    EXPECT_GT(camera.eye.z, 0.0f);
    EXPECT_TRUE(showsSomething(mesh, camera));
}

TEST(AutoCamera, DoesNotDependOnTheUnitOfLength) {
    // Powers of two, so that the scaled scene is exactly the same.
    const Standpoint one = choose(hall());
    for (float scale : {std::ldexp(1.0f, -20), std::ldexp(1.0f, 20)}) {
        const Standpoint other = choose(scaled(hall(), scale));
        EXPECT_EQ(other.camera.eye, one.camera.eye * scale);
        EXPECT_EQ(other.camera.target, one.camera.target * scale);
        EXPECT_EQ(other.light.position, one.light.position * scale);
        EXPECT_EQ(other.light.flux, one.light.flux * scale * scale);
    }
}

TEST(AutoCamera, KeepsWhatIsGiven) {
    CameraHints hints;
    hints.eye = glm::vec3(3, 2, 1);
    hints.up = glm::vec3(0, 0, 1);
    hints.verticalFov = 30.0f;
    const Camera fromEye = choose(hall(), hints).camera;
    EXPECT_EQ(fromEye.eye, *hints.eye);
    EXPECT_EQ(fromEye.up, hints.up);
    EXPECT_EQ(fromEye.verticalFov, 30.0f);

    hints.target = glm::vec3(-4, 1, 0);
    const Camera both = choose(hall(), hints).camera;
    EXPECT_EQ(both.eye, *hints.eye);
    EXPECT_EQ(both.target, *hints.target);

    hints.eye.reset();
    const Camera toTarget = choose(hall(), hints).camera;
    EXPECT_EQ(toTarget.target, *hints.target);
    EXPECT_NE(toTarget.eye, *hints.target);
}

TEST(AutoCamera, LooksAtFlatAndTinyScenes) {
    Mesh floor, wall, point;
    addQuad(floor, {-1, 0, -1}, {-1, 0, 1}, {1, 0, 1}, {1, 0, -1});
    addQuad(wall, {-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0});
    point.positions = {glm::vec3(1, 2, 3)};
    point.triangles = {{0, 0, 0}};
    EXPECT_TRUE(showsSomething(floor, choose(floor).camera));
    EXPECT_TRUE(showsSomething(wall, choose(wall).camera));
    const Standpoint nothing = choose(point);
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_TRUE(std::isfinite(nothing.camera.eye[axis]));
        EXPECT_TRUE(std::isfinite(nothing.light.position[axis]));
    }
    EXPECT_NE(nothing.camera.eye, nothing.camera.target);
}

} // namespace
} // namespace dirt
