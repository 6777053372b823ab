#include "core/frame/auto_camera.h"

#include "backend_cpu/cpu_backend.h"
#include "backend_cpu/thread_pool.h"
#include "core/frame/framing.h"
#include "core/trace/offset.h"
#include "core/trace/traverse.h"
#include "tests/support/made_models.h"

#include <array>
#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace dirt {
namespace {

using namespace test;

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

/// Leaves every ray free, and keeps how near to its own triangle each one ran that was cast.
class GrazeWatcher final : public Tracer {
public:
    std::string name() const override { return "graze watcher"; }
    std::string device() const override { return ""; }
    std::vector<PassTime> build(const FrameGeometry& geometry, const Camera&,
                                const GridSettings&) override {
        geometry_ = &geometry;
        return {};
    }
    void intersect(std::span<const Ray>, std::span<Hit> hits) override {
        std::fill(hits.begin(), hits.end(), Hit{});
    }
    void occluded(std::span<const Ray> rays, std::span<const float> maxT,
                  std::span<uint8_t> result) override {
        std::fill(result.begin(), result.end(), uint8_t(0));
        for (size_t i = 0; i < rays.size(); ++i) {
            if (maxT[i] == 0.0f || rays[i].skip == kNoPrimitive) continue;
            const Triangle& t = geometry_->triangles[rays[i].skip];
            const glm::dvec3 normal =
                glm::cross(glm::dvec3(t.b) - glm::dvec3(t.a), glm::dvec3(t.c) - glm::dvec3(t.a));
            const glm::dvec3 way(rays[i].direction);
            least =
                std::min(least, std::abs(glm::dot(glm::normalize(normal), way)) / glm::length(way));
            ++rayCount;
        }
    }

    double least = 1.0; ///< cosine with the normal
    size_t rayCount = 0;

private:
    const FrameGeometry* geometry_ = nullptr;
};

/// Along a flat polygon of 100,000 corners a ray passes through all triangles. Turned by a right
/// angle a direction misses the plane by a rounding.
TEST(AutoCamera, CastsNoRayAlongTheSurface) {
    for (int axis = 0; axis < 3; ++axis) {
        Mesh mesh;
        glm::vec3 along(0), across(0);
        along[(axis + 1) % 3] = across[(axis + 2) % 3] = 2.0f;
        const glm::vec3 corner(0.5f);
        addQuad(mesh, corner, corner + along, corner + along + across, corner + across);
        GrazeWatcher watcher;
        chooseStandpoint(mesh, watcher, {});
        EXPECT_GT(watcher.rayCount, 10'000u);
        EXPECT_GT(watcher.least, 1e-3) << axis;
    }
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
    Mesh mesh;
    addBall(mesh, glm::vec3(0), 1.0f, 24);
    const Camera camera = choose(mesh).camera;
    EXPECT_GT(glm::length(camera.eye), 1.2f);
    EXPECT_LT(glm::length(camera.eye), 8.0f);
    EXPECT_TRUE(showsSomething(mesh, camera));
}

/// A slab that is bare on one side, which at a slant is as deep as the other, where towers stand.
TEST(AutoCamera, PrefersWhatIsThereToABareWall) {
    Mesh mesh;
    addRoom(mesh, {-10, -12, -0.2f}, {10, 12, 0}, false);
    for (int i = -8; i <= 8; i += 4)
        addRoom(mesh, {(float) i - 1, (float) i - 3, 0}, {(float) i + 1, (float) i + 3, 8}, false);
    const Camera camera = choose(mesh).camera;
    EXPECT_GT(camera.eye.z, 0.0f);
    EXPECT_TRUE(showsSomething(mesh, camera));
}

/// Whether all corners are in the picture, and how much of its width or height they fill.
void expectWhole(const Mesh& mesh, const Camera& camera, float aspect) {
    const Framing framing(glm::dvec3(camera.target) - glm::dvec3(camera.eye), camera.up,
                          camera.verticalFov, aspect);
    double fills = 0.0;
    for (const glm::vec3& p : mesh.positions) {
        const glm::dvec3 way = glm::dvec3(p) - glm::dvec3(camera.eye);
        ASSERT_TRUE(framing.contains(p, camera.eye));
        const double depth = glm::dot(way, framing.forward);
        fills = std::max({fills, std::abs(glm::dot(way, framing.right)) / (depth * framing.wide),
                          std::abs(glm::dot(way, framing.down)) / (depth * framing.tall)});
    }
    // Nine tenths; the axes are rounded to float, some 1e-7.
    EXPECT_NEAR(fills, 0.9, 1e-5);
}

bool isInBox(const Mesh& mesh, glm::vec3 point) {
    glm::vec3 low(INFINITY), high(-INFINITY);
    for (const glm::vec3& p : mesh.positions)
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], p[axis]);
            high[axis] = std::max(high[axis], p[axis]);
        }
    for (int axis = 0; axis < 3; ++axis)
        if (point[axis] < low[axis] || point[axis] > high[axis]) return false;
    return true;
}

TEST(AutoCamera, ShowsObjectsWholeFromOutside) {
    for (const auto& [name, mesh] : objects())
        for (float aspect : {0.25f, 8.0f}) {
            SCOPED_TRACE(name);
            CameraHints hints;
            hints.aspect = aspect;
            const Camera camera = choose(mesh, hints).camera;
            EXPECT_FALSE(isInBox(mesh, camera.eye));
            expectWhole(mesh, camera, aspect);
        }
}

/// The camera's direction as seen from the model: x to the right, y up, z towards the viewer.
glm::vec3 sideOf(const Mesh& mesh, const CameraHints& hints = {}) {
    return -cameraBasis(choose(mesh, hints).camera).forward;
}

TEST(AutoCamera, ShowsObjectsFromInFrontAndSlightlyAbove) {
    const glm::vec3 slightlyAbove = glm::normalize(glm::vec3(0, 1, 3));
    for (const Mesh& mesh :
         {box(false), box(true), hollowBox(0.1f), hollowBox(0.001f), table(), ballInABall(), tree(),
          court(), sign(1), square(2, true), caseWithABall(), twoSidedRoom(), tray()})
        EXPECT_LT(glm::length(sideOf(mesh) - slightlyAbove), 1e-5f);
}

TEST(AutoCamera, ShowsWhatHasItsFrontElsewhereFromThere) {
    EXPECT_LT(sideOf(sign(-1)).z, -0.9f);
    EXPECT_LT(sideOf(labelsBehindABoard()).z, -0.9f);
    EXPECT_LT(sideOf(screenBehind()).z, -0.6f);
    EXPECT_LT(sideOf(square(2, false)).z, -0.9f);
    EXPECT_GT(sideOf(square(0, true)).x, 0.9f);
    EXPECT_LT(sideOf(square(0, false)).x, -0.9f);
    // A floor or a ceiling from halfway above or below, and from in front.
    EXPECT_LT(glm::length(sideOf(square(1, true)) - std::sqrt(0.5f) * glm::vec3(0, 1, 1)), 1e-5f);
    EXPECT_LT(glm::length(sideOf(square(1, false)) - std::sqrt(0.5f) * glm::vec3(0, -1, 1)), 1e-5f);
    // Into a bowl, all of whose front is seen from above.
    EXPECT_LT(glm::length(sideOf(bowl()) - std::sqrt(0.5f) * glm::vec3(0, 1, 1)), 1e-5f);
    // A long thing that points at the viewer, from its side.
    Mesh rod;
    addRoom(rod, {-0.1f, -0.1f, -2}, {0.1f, 0.1f, 2}, false);
    EXPECT_LT(std::abs(sideOf(rod).z), 0.75f);
    Mesh twoSided;
    addTwoSidedBox(twoSided, {-0.1f, -0.1f, -2}, {0.1f, 0.1f, 2});
    EXPECT_LT(std::abs(sideOf(twoSided).z), 0.75f);
}

/// From slightly above one sees the top, be it of a die or of a tower: the eye is above it.
TEST(AutoCamera, ShowsTheTop) {
    for (const float height : {0.5f, 1.0f, 4.0f}) {
        Mesh mesh;
        addRoom(mesh, {-0.5f, 0, -0.5f}, {0.5f, height, 0.5f}, false);
        const Camera camera = choose(mesh).camera;
        EXPECT_GT(camera.eye.y, height);
        EXPECT_EQ(camera.verticalFov, 30.0f);
    }
    EXPECT_EQ(choose(hall()).camera.verticalFov, 53.0f);
}

TEST(AutoCamera, TakesZUpAsItIsTold) {
    EXPECT_GT(sideOf(zUpHouse()).z, 0.5f); // as Y up, it lies on its back: not from below
    CameraHints hints;
    hints.up = {0, 0, 1};
    const glm::vec3 side = sideOf(zUpHouse(), hints);
    EXPECT_LT(side.y, -0.9f);
    EXPECT_GT(side.z, 0.0f);
}

TEST(AutoCamera, LooksIntoRooms) {
    for (const auto& [name, mesh] : rooms()) {
        SCOPED_TRACE(name);
        const Camera camera = choose(mesh).camera;
        // The nearest surface before the lens shows its front: no wall is looked through.
        const FrameGeometry geometry = makeFrameGeometry(mesh, camera, ViewMode::full);
        Ray ray;
        ray.direction = cameraBasis(camera).forward;
        const Hit hit = closestHitBruteForce(geometry, ray);
        ASSERT_TRUE(hit.found());
        const Triangle& t = geometry.triangles[hit.primitive];
        EXPECT_LT(glm::dot(glm::cross(t.b - t.a, t.c - t.a), ray.direction), 0.0f);
    }
    EXPECT_TRUE(isInBox(hall(), choose(hall()).camera.eye));
    // Through the opening, or within.
    EXPECT_GT(choose(openRoom(front)).camera.eye.z, -1.0f);
    EXPECT_LT(choose(openRoom(back)).camera.eye.z, 1.0f);
    EXPECT_LT(choose(openRoom(left)).camera.eye.x, 1.0f);
}

TEST(AutoCamera, LightsMostOfWhatItShows) {
    for (const auto& models : {objects(), rooms()})
        for (const auto& [name, mesh] : models) {
            SCOPED_TRACE(name);
            const auto [camera, light] = choose(mesh);
            const FrameGeometry geometry = makeFrameGeometry(mesh, camera, ViewMode::full);
            const CameraBasis basis = cameraBasis(camera);
            int seen = 0, dark = 0;
            for (int i = 0; i < 49; ++i) {
                const float x = 0.15f * (float) (i % 7 - 3), y = 0.15f * (float) (i / 7 - 3);
                Ray ray;
                ray.direction = basis.forward + x * basis.right + y * basis.down;
                const Hit hit = closestHitBruteForce(geometry, ray);
                if (!hit.found()) continue;
                const glm::vec3 point = hit.t * ray.direction;
                const glm::vec3 lamp = geometry.frame.toGrid(light.position);
                ray.origin = offsetOrigin(geometry.triangles[hit.primitive], hit.u, hit.v,
                                          lamp - point); // as rays of a path do
                ray.direction = lamp - ray.origin;
                ray.skip = hit.primitive;
                const Hit between = closestHitBruteForce(geometry, ray);
                ++seen;
                dark += between.found() && between.t < 1.0f;
            }
            EXPECT_GT(seen, 0);
            EXPECT_LE(2 * dark, seen);
        }
}

/// The twin of the wall that is lit does not keep the light from it.
TEST(AutoCamera, LightsTwoSidedWallsFromBesideTheEye) {
    const auto [camera, light] = choose(twoSidedRoom());
    EXPECT_NE(light.position, camera.eye);
}

TEST(AutoCamera, DoesNotDependOnThreads) {
    for (const Mesh& mesh : {hall(), tree()}) {
        const Standpoint one = choose(mesh);
        for (unsigned threads : {2u, 7u}) {
            ThreadPool pool(threads);
            CpuBackend backend(pool);
            const Standpoint other = chooseStandpoint(mesh, backend, {});
            EXPECT_EQ(other.camera.eye, one.camera.eye);
            EXPECT_EQ(other.camera.target, one.camera.target);
            EXPECT_EQ(other.light.position, one.light.position);
        }
    }
}

TEST(AutoCamera, IsFiniteForEveryTriangle) {
    const float inf = INFINITY;
    for (float scale : {1e-25f, 1e-6f, 1.0f, 1e6f, 1e25f})
        for (float far : {0.0f, 1.0f, 1e7f})
            for (const std::array<glm::vec3, 3>& corners :
                 {std::array<glm::vec3, 3>{glm::vec3(0), {1, 0, 0}, {0, 1, 0}}, // one triangle
                  std::array<glm::vec3, 3>{glm::vec3(0), {1, 1, 1}, {2, 2, 2}}, // a line
                  std::array<glm::vec3, 3>{glm::vec3(0), {0, 0, 1}, {0, 0, 2}}, // along the view
                  std::array<glm::vec3, 3>{glm::vec3(0), glm::vec3(0), glm::vec3(0)}}) {
                Mesh mesh;
                for (const glm::vec3& p : corners)
                    mesh.positions.push_back(scale * (p + glm::vec3(far)));
                mesh.triangles = {{0, 1, 2}};
                const Standpoint result = choose(mesh);
                for (int axis = 0; axis < 3; ++axis) {
                    EXPECT_LT(std::abs(result.camera.eye[axis]), inf);
                    EXPECT_LT(std::abs(result.camera.target[axis]), inf);
                    EXPECT_LT(std::abs(result.light.position[axis]), inf);
                }
                EXPECT_NE(result.camera.eye, result.camera.target);
                EXPECT_NE(result.light.position, result.light.target);
            }
}

TEST(AutoCamera, DoesNotDependOnTheUnitOfLength) {
    // Powers of two, so that the scaled scene is exactly the same.
    const Standpoint one = choose(hall());
    for (int exponent : {-83, -20, 20, 83}) {
        const float scale = std::ldexp(1.0f, exponent);
        const Standpoint other = choose(scaled(hall(), scale));
        EXPECT_EQ(other.camera.eye, one.camera.eye * scale);
        EXPECT_EQ(other.camera.target, one.camera.target * scale);
        EXPECT_EQ(other.light.position, one.light.position * scale);
        EXPECT_EQ(other.light.flux, one.light.flux * scale * scale); // in double
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
