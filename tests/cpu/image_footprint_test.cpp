// The pixels that triangles may be seen in, and which triangles are in none.

#include "backend_cpu/image/image_footprint.h"
#include "core/path/camera_rays.h"
#include "core/trace/intersect.h"
#include "tests/cpu/surface_points.h"
#include "tests/frame/shapes.h"
#include "tests/support/simd_targets.h"
#include "tests/support/small_scenes.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace dirt {
namespace {

TEST(ImageFootprint, HoldsEveryPixelThatIsHit) {
    // Slivers that pass pixel centres closely, at the image's rim and through the eye's plane.
    test::Random random(3);
    size_t hits = 0, pixels = 0;
    for (int i = 0; i < test::cases(20'000, 1'000'000); ++i) {
        const int width = random.range(1, 9), height = random.range(1, 9);
        const ViewMode mode = random.chance(0.5) ? ViewMode::full : ViewMode::single;
        Camera camera;
        camera.verticalFov = (float) random.pick({0.5, 20.0, 90.0, 170.0, 179.5});
        camera.target = test::randomDirection(random);
        camera.up = test::randomDirection(random);
        const glm::vec2 offset((float) random.below(4) * 0.25f, (float) random.uniform());
        const CameraRays rays(camera, width, height, mode);
        const auto rayAt = [&](int x, int y) {
            return rays.through((float) x + offset.x, (float) y + offset.y);
        };
        // Corners on or beside pixels' rays, at any depth, or anywhere.
        const auto corner = [&] {
            if (random.chance(0.3)) return test::uniformPoint(random, 1.0);
            if (random.chance(0.2)) { // in the eye's plane, exactly or nearly
                const glm::vec3 p = test::uniformPoint(random, 1.0);
                if (mode == ViewMode::single) return glm::vec3(p.x, p.y, 0.0f);
                const glm::vec3 forward = glm::normalize(camera.target);
                return p - forward * glm::dot(p, forward);
            }
            const Ray ray = rayAt(random.range(-1, width), random.range(-1, height));
            const float depth = (float) std::pow(10.0, random.uniform(-4, 0));
            const float beside = random.chance(0.5) ? 0.0f : 1e-7f;
            return ray.direction * depth + test::uniformPoint(random, beside * depth);
        };
        const Triangle triangle{corner(), corner(), corner()};
        const ImageFootprint footprint(camera, width, height, mode, offset);
        const PixelRange range = footprint(triangle);
        uint32_t one[1 + kKeptPadding];
        const bool kept = keepInImage(footprint.cull(), {&triangle, 1}, one) == 1;
        pixels += (size_t) std::max(0, range.x1 - range.x0 + 1) *
                  (size_t) std::max(0, range.y1 - range.y0 + 1);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                TriangleHit hit;
                if (!intersect(rayAt(x, y), triangle, hit)) continue;
                ++hits;
                ASSERT_TRUE(kept) << "case " << i << ", pixel " << x << ", " << y;
                ASSERT_TRUE(x >= range.x0 && x <= range.x1 && y >= range.y0 && y <= range.y1)
                    << "case " << i << ", pixel " << x << ", " << y;
            }
    }
    EXPECT_GT(hits, pixels / 8) << "the range is of use only if it is not much too large";
}

TEST(ImageFootprint, IsSmallWhereVerticesLieInTheEyesPlane) {
    // A floor of 40 x 40 quads on whole numbers, seen from a whole number.
    for (const ViewMode mode : {ViewMode::full, ViewMode::single}) {
        Mesh mesh;
        for (int x = -20; x < 20; ++x)
            for (int z = -20; z < 20; ++z) test::addQuad(mesh, {x, -1, z}, {1, 0, 0}, {0, 0, 1}, 0);
        const Camera camera;
        const FrameGeometry geometry = makeFrameGeometry(mesh, camera, mode);
        const ImageFootprint footprint(camera, 200, 100, mode, {0.5f, 0.5f});
        size_t pixels = 0;
        for (const Triangle& triangle : geometry.triangles) {
            const PixelRange range = footprint(triangle);
            if (range.x0 <= range.x1 && range.y0 <= range.y1)
                pixels += (size_t) (range.x1 - range.x0 + 1) * (size_t) (range.y1 - range.y0 + 1);
        }
        EXPECT_LT(pixels, 4u * 200u * 100u);
    }
}

TEST(ImageFootprint, KeepsWhatItHoldsOnEveryInstructionSet) {
    // Small triangles all around, also at pixels' centres: of those without a pixel few are kept,
    // of the others none is left out.
    test::Random random(9);
    for (const ViewMode mode : {ViewMode::full, ViewMode::single}) {
        Camera camera;
        camera.target = test::randomDirection(random);
        const ImageFootprint footprint(camera, 300, 200, mode, {0.25f, 0.75f});
        const CameraRays rays(camera, 300, 200, mode);
        std::vector<Triangle> triangles;
        for (int i = 0; i < 5000; ++i) {
            const double size = std::pow(10.0, random.uniform(-6, 0));
            const glm::vec3 d =
                rays.through((float) random.below(300) + 0.25f, (float) random.below(200) + 0.75f)
                    .direction;
            const glm::vec3 center =
                random.chance(0.5) ? test::uniformPoint(random, 1.0) : d * (float) random.uniform();
            triangles.push_back({center + test::uniformPoint(random, size),
                                 center + test::uniformPoint(random, size),
                                 center + test::uniformPoint(random, size)});
        }
        test::forEachTarget([&] {
            std::vector<uint32_t> kept(triangles.size() + kKeptPadding);
            const size_t count = keepInImage(footprint.cull(), triangles, kept.data());
            size_t next = 0, idle = 0;
            for (uint32_t id = 0; id < triangles.size(); ++id) {
                const PixelRange range = footprint(triangles[id]);
                const bool empty = range.x0 > range.x1 || range.y0 > range.y1;
                const bool isKept = next < count && kept[next] == id;
                ASSERT_TRUE(empty || isKept) << "triangle " << id;
                next += isKept;
                idle += empty && isKept;
            }
            EXPECT_EQ(next, count);
            EXPECT_LT(idle, count / 10);
        });
    }
}

} // namespace
} // namespace dirt
