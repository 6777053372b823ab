// Which differences of direct visibility are tolerated: distances to edges and to the line in which
// two triangles meet, against plain arithmetic; and a rasterizer with snapped vertices, of which
// all must be tolerated and a coarser one must not.

#include "core/check/adjudicate_visibility.h"

#include "backend_cpu/cpu_backend.h"
#include "core/check/check.h"
#include "core/path/camera_rays.h"
#include "tests/check/snapping_backend.h"
#include "tests/frame/shapes.h"
#include "tests/support/small_scenes.h"

#include <cmath>

#include <gtest/gtest.h>

namespace dirt::test {
namespace {

constexpr double kReach = 1.0 / 128.0;

/// A camera that looks along +z from the origin in single mode: pixels and points of the grid frame
/// by plain arithmetic.
struct Picture {
    GridSettings settings;
    Camera camera;
    glm::vec2 offset{0.25f, 0.75f};

    Picture() {
        settings.mode = ViewMode::single;
        settings.width = 64;
        settings.height = 48;
        camera.verticalFov = 60.0f;
    }
    double pixelsPerSlope() const {
        return settings.height * 0.5 / std::tan(camera.verticalFov * std::acos(-1.0) / 360.0);
    }
    glm::dvec2 sampleOf(size_t pixel) const {
        return glm::dvec2(pixel % (size_t) settings.width, pixel / (size_t) settings.width) +
               glm::dvec2(offset);
    }
    glm::dvec2 project(const glm::dvec3& p) const {
        return glm::dvec2(p) / p.z * pixelsPerSlope() +
               glm::dvec2(settings.width, settings.height) * 0.5;
    }
    /// The point of the grid frame at depth \p w that is seen at \p at.
    glm::vec3 unproject(glm::dvec2 at, double w) const {
        const glm::dvec2 slope =
            (at - glm::dvec2(settings.width, settings.height) * 0.5) / pixelsPerSlope();
        return glm::vec3(glm::dvec3(slope * w, w));
    }
};

double distanceToSegment(glm::dvec2 p, glm::dvec2 a, glm::dvec2 b) {
    const glm::dvec2 along = b - a;
    const double length = glm::dot(along, along);
    const double s = length > 0.0 ? std::clamp(glm::dot(p - a, along) / length, 0.0, 1.0) : 0.0;
    return glm::length(p - a - s * along);
}

/// Of the part of an edge before the eye.
double distanceToEdge(const Picture& picture, glm::dvec2 sample, glm::dvec3 a, glm::dvec3 b) {
    if (a.z <= 0.0 && b.z <= 0.0) return INFINITY;
    constexpr double near = 1e-9;
    if (a.z < near) a += (b - a) * ((near - a.z) / (b.z - a.z));
    if (b.z < near) b += (a - b) * ((near - b.z) / (a.z - b.z));
    return distanceToSegment(sample, picture.project(a), picture.project(b));
}

TEST(VisibilityJudge, AsksForTheDistanceToEdges) {
    const Picture picture;
    Random random(1);
    int near = 0, far = 0, behind = 0;
    for (int i = 0; i < cases(3000, 100000); ++i) {
        const size_t pixel = (size_t) random.below(64 * 48);
        const glm::dvec2 sample = picture.sampleOf(pixel);
        // An edge, or the end of one, at about 1/128 of a pixel; one vertex may be behind the eye.
        const double angle = random.uniform(0.0, 6.3), reach = random.uniform(0.0, 2.0 * kReach);
        const glm::dvec2 towards(std::cos(angle), std::sin(angle)), along(-towards.y, towards.x);
        const glm::dvec2 foot = sample + towards * reach;
        const double length = std::pow(10.0, random.uniform(-3, 2));
        const double start = random.chance(0.3) ? 0.0 : random.uniform(-1, 1) * length;
        FrameGeometry geometry;
        Triangle t{picture.unproject(foot + along * start, random.uniform(0.1, 1.9)),
                   picture.unproject(foot + along * (start + length), random.uniform(0.1, 1.9)),
                   picture.unproject(foot + towards * random.uniform(0, 50), 1.0)};
        if (random.chance(0.3)) {
            t.b = t.a + (t.a - t.b) * (float) random.uniform(0.1, 3.0); // the line goes on there
            behind += t.b.z < 0.0f;
        }
        geometry.triangles = {t};
        const glm::dvec3 a(t.a), b(t.b), c(t.c);
        const double distance =
            std::min({distanceToEdge(picture, sample, a, b), distanceToEdge(picture, sample, b, c),
                      distanceToEdge(picture, sample, c, a)});
        if (std::abs(distance - kReach) < 1e-4) continue; // what the pixel's ray has rounded
        const VisibilityJudge judge(geometry, picture.camera, picture.settings, picture.offset);
        ASSERT_EQ(judge.mayConfuse(pixel, 0, kNoPrimitive), distance < kReach)
            << distance * 128 << "/128 in case " << i;
        EXPECT_EQ(judge.mayConfuse(pixel, kNoPrimitive, 0), distance < kReach);
        ++(distance < kReach ? near : far);
    }
    EXPECT_GT(near, 500);
    EXPECT_GT(far, 500);
    EXPECT_GT(behind, 50);
}

TEST(VisibilityJudge, AsksWhereTwoTrianglesMeet) {
    const Picture picture;
    Random random(2);
    int near = 0, far = 0;
    for (int i = 0; i < cases(1000, 30000); ++i) {
        const size_t pixel = (size_t) random.below(64 * 48);
        const glm::dvec2 sample = picture.sampleOf(pixel);
        // Two large triangles through one line, seen at a distance of the sample.
        const double angle = random.uniform(0.0, 6.3), reach = random.uniform(0.0, 2.0 * kReach);
        const glm::dvec2 towards(std::cos(angle), std::sin(angle)), along(-towards.y, towards.x);
        const glm::dvec2 foot = sample + towards * reach;
        const glm::vec3 a = picture.unproject(foot - along * 20.0, random.uniform(0.5, 1.0));
        const glm::vec3 b = picture.unproject(foot + along * 20.0, random.uniform(0.5, 1.0));
        const auto through = [&] {
            const glm::vec3 far =
                picture.unproject(foot + towards * 20.0, random.uniform(0.5, 1.0));
            const glm::vec3 middle = 0.5f * (a + b);
            // From a corner beyond the line, across it.
            return Triangle{middle + (middle - far), far + (b - a) * 2.0f, far + (a - b) * 2.0f};
        };
        FrameGeometry geometry;
        geometry.triangles = {through(), through()};
        const Triangle& s = geometry.triangles[0];
        const Triangle& t = geometry.triangles[1];
        const glm::dvec3 n =
            glm::cross(glm::dvec3(s.b) - glm::dvec3(s.a), glm::dvec3(s.c) - glm::dvec3(s.a));
        const glm::dvec3 m =
            glm::cross(glm::dvec3(t.b) - glm::dvec3(t.a), glm::dvec3(t.c) - glm::dvec3(t.a));
        const double h = glm::dot(n, glm::dvec3(s.a)), k = glm::dot(m, glm::dvec3(t.a));
        // Where 1/w of both planes is equal, which is linear in the image.
        const auto gap = [&](glm::dvec2 at) {
            const glm::dvec3 d(picture.unproject(at, 1.0));
            return glm::dot(n, d) / h - glm::dot(m, d) / k;
        };
        const glm::dvec2 gradient(gap(sample + glm::dvec2(1, 0)) - gap(sample),
                                  gap(sample + glm::dvec2(0, 1)) - gap(sample));
        const double distance = std::abs(gap(sample)) / glm::length(gradient);
        if (!(std::abs(distance - kReach) > 2e-4)) continue;
        const VisibilityJudge judge(geometry, picture.camera, picture.settings, picture.offset);
        ASSERT_EQ(judge.mayConfuse(pixel, 0, 1), distance < kReach)
            << distance * 128 << "/128 in case " << i;
        ++(distance < kReach ? near : far);
    }
    EXPECT_GT(near, 100);
    EXPECT_GT(far, 100);
}

TEST(VisibilityJudge, ToleratesTiesOnlyOfTrianglesThatAreHit) {
    const Picture picture;
    const size_t pixel = 20 * 64 + 20;
    const glm::dvec2 sample = picture.sampleOf(pixel);
    const auto at = [&](double x, double y) {
        return picture.unproject(sample + glm::dvec2(x, y), 1.0);
    };
    FrameGeometry geometry;
    geometry.triangles = {{at(-5, -5), at(9, -5), at(-5, 9)},
                          {at(-4, -4), at(9, -4), at(-4, 9)}, // in the same plane
                          {at(1, 1), at(9, 1), at(1, 9)}};    // likewise, but beside the sample
    const VisibilityJudge judge(geometry, picture.camera, picture.settings, picture.offset);
    EXPECT_TRUE(judge.mayConfuse(pixel, 0, 1));
    EXPECT_FALSE(judge.mayConfuse(pixel, 0, 2));
    EXPECT_FALSE(judge.mayConfuse(pixel, 0, kNoPrimitive));
    EXPECT_FALSE(judge.mayConfuse(pixel, 0, 3)); // there is none
}

/// Counts of DirectVisibility, with \p raster positions along a pixel.
CheckRow directVisibility(const Scene& scene, const RenderSettings& settings, double raster) {
    SerialExecutor executor;
    CpuBackend cpu(executor), inner(executor);
    SnappingBackend snapping(inner, raster);
    CheckRow sum;
    for (const CheckRow& row : checkBackends(scene, settings, cpu, snapping).rows) {
        if (row.pass != "DirectVisibility") {
            EXPECT_EQ(row.different, 0u) << row.pass << row.buffer;
            continue;
        }
        sum.compared += row.compared;
        sum.withinTolerance += row.withinTolerance;
        sum.different += row.different;
        sum.examples.insert(sum.examples.end(), row.examples.begin(), row.examples.end());
    }
    return sum;
}

TEST(VisibilityJudge, ToleratesARasterOfOne256thAndNoCoarserOne) {
    Random random(3);
    uint64_t tolerated = 0, coarse = 0;
    for (int i = 0; i < cases(30, 1000); ++i) {
        RenderSettings settings;
        settings.grid.mode = random.chance(0.5) ? ViewMode::full : ViewMode::single;
        settings.grid.width = random.range(20, 120);
        settings.grid.height = random.range(20, 80);
        settings.bounces = 1;
        settings.seed = (uint32_t) i;
        Scene scene = room();
        if (i % 3) {
            std::vector<Triangle> triangles;
            addSoup(random, triangles, 60);
            addRoom(random, triangles);
            scene = sceneOf(triangles);
        }
        scene.camera.verticalFov = (float) random.pick({20.0, 53.0, 90.0, 140.0});
        scene.camera.target = scene.camera.eye + uniformPoint(random, 1.0);
        const CheckRow row = directVisibility(scene, settings, 256.0);
        EXPECT_EQ(row.different, 0u)
            << (row.examples.empty() ? "" : row.examples[0]) << " case " << i;
        tolerated += row.withinTolerance;
        coarse += directVisibility(scene, settings, 16.0).different;
    }
    EXPECT_GT(tolerated, 5u);
    EXPECT_GT(coarse, 50u);
}

} // namespace
} // namespace dirt::test
