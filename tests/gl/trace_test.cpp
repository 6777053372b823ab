// Rays traced in GLSL against the traversal in core, bit for bit: hits and the tiles that list
// them.

#include "backend_gl/gl_backend.h"
#include "core/base/denormals.h"
#include "core/trace/traverse.h"
#include "tests/support/border_rays.h"
#include "tests/support/final_hits.h"
#include "tests/support/grid_rays.h"
#include "tests/support/print.h"
#include "tests/support/small_scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

namespace dirt::test {
namespace {

const int kRays = cases(96, 512); // of a scene

ViewSet randomViews(Random& random, ViewMode mode) {
    GridSettings settings;
    settings.mode = mode;
    settings.tile = random.pick({1, 1, 2, 4, 7, 16, 64});
    const int tiles = random.pick({1, 2, 3, 8, 17, 32});
    settings.viewSize = std::max(1, tiles * settings.tile - random.below(settings.tile));
    settings.width = settings.viewSize + random.below(40);
    settings.height = settings.viewSize;
    settings.bins = random.pick({1, 2, 16, 44});
    settings.maxMip = random.range(-1, 7);
    settings.traversal = random.chance(0.3) ? Traversal::linear : Traversal::hierarchical;
    Camera camera;
    camera.verticalFov = random.pick({1.0f, 30.0f, 90.0f, 150.0f, 170.0f});
    return {settings, camera};
}

std::string text(const Hit& hit) {
    if (!hit.found()) return "nothing";
    return std::to_string(hit.primitive) + " at t " + hex(hit.t) + " u " + hex(hit.u) + " v " +
           hex(hit.v) + " in view " + std::to_string(hit.view) + " tile " +
           std::to_string(hit.tile);
}

/// To the bit, but for the signs of zeros.
bool sameHit(const Hit& a, const Hit& b) {
    return a.primitive == b.primitive && a.t == b.t && a.u == b.u && a.v == b.v &&
           a.view == b.view && a.tile == b.tile && a.fetches == b.fetches;
}

/// What a backend finds of rays: nearest hits, and any before maxT.
struct Answers {
    std::vector<Hit> hits;
    std::vector<uint8_t> occluded;
};

Answers answersOf(GlBackend& gl, const FrameGeometry& geometry, const Grid& grid,
                  const std::vector<Ray>& rays, const std::vector<float>& maxT) {
    gl.setGeometry(geometry);
    gl.writeGrid(grid);
    Answers answers{std::vector<Hit>(rays.size()), std::vector<uint8_t>(rays.size())};
    gl.intersect(rays, answers.hits);
    gl.occluded(rays, maxT, answers.occluded);
    return answers;
}

/// In several dispatches, as loops are left, and in one.
TEST(GlTrace, EqualsTheDefinition) {
    GlBackend turns(GlOptions{.resumes = true}), whole(GlOptions{.resumes = false});
    const FlushDenormals flush; // as every worker of the CPU does
    Random random(11);
    for (int round = 0; round < cases(6, 1000); ++round) {
        const ViewSet set = randomViews(random, round % 3 ? ViewMode::full : ViewMode::single);
        FrameGeometry geometry;
        geometry.frame.mode = set.settings.mode;
        geometry.triangles = smallScene(random, set);
        const Grid grid = buildGrid(geometry, set.camera, set.settings);

        GridRays generator(random, set, geometry.triangles);
        std::vector<Ray> rays;
        std::vector<float> maxT;
        for (int i = 0; i < kRays; ++i) {
            rays.push_back(generator.next().ray);
            if (random.chance(0.1))
                rays.back().skip = (uint32_t) random.below((int) geometry.triangles.size());
            maxT.push_back((float) std::abs(random.wide(-2, 1)));
        }
        rays[7].direction = glm::vec3(0.0f);
        rays[8].direction.y = NAN;
        rays[9].origin.x = HUGE_VALF;
        maxT[10] = 0.0f;
        std::vector<Hit> expected;
        std::vector<bool> expectedAny;
        for (size_t i = 0; i < rays.size(); ++i) {
            expected.push_back(closestHit(grid, geometry, rays[i]));
            expectedAny.push_back(anyHit(grid, geometry, rays[i], maxT[i]));
        }
        for (GlBackend* gl : {&turns, &whole}) {
            const auto [hits, occluded] = answersOf(*gl, geometry, grid, rays, maxT);
            for (size_t i = 0; i < rays.size(); ++i) {
                ASSERT_TRUE(sameHit(hits[i], expected[i]))
                    << text(expected[i]) << ", not " << text(hits[i]) << "\n"
                    << hex(rays[i]) << " in round " << round << ", " << describe(set);
                ASSERT_EQ(occluded[i] != 0, expectedAny[i])
                    << hex(rays[i]) << " before " << maxT[i] << " in round " << round;
            }
        }
    }
}

/// Small triangles in the way of rays along a border, of which doubles cannot tell when they cross
/// it: none is missed, whichever tile lists it.
TEST(GlTrace, FindsWhatLiesBesideABorder) {
    GlBackend gl;
    const FlushDenormals flush;
    Random random(12);
    int found = 0;
    for (int i = 0; i < cases(150, 5000); ++i) {
        const auto [set, ray, geometry] = borderCase(random);
        const Grid grid = buildGrid(geometry, set.camera, set.settings);
        gl.setGeometry(geometry);
        gl.writeGrid(grid);
        std::vector<Hit> hits(1);
        gl.intersect(std::vector<Ray>{ray}, hits);
        const Hit expected = closestHit(grid, geometry, ray);
        ASSERT_TRUE(sameHit(hits[0], expected)) << text(expected) << ", not " << text(hits[0]);
        found += expected.found();
    }
    EXPECT_GT(found, 50);
}

/// Rays that are aimed at nothing: what a search in float misses is aimed at edges and borders. In
/// several dispatches it finds the same as in one, to the bit.
TEST(GlTrace, FastFindsTheSameButAtEdges) {
    GlBackend turns(GlOptions{.resumes = true}), whole(GlOptions{.resumes = false});
    const FlushDenormals flush;
    Random random(15);
    int compared = 0, different = 0, found = 0;
    for (int round = 0; round < cases(12, 300); ++round) {
        ViewSet set = randomViews(random, round % 3 ? ViewMode::full : ViewMode::single);
        set.settings.precision = Precision::fast;
        const bool isDense = round % 4 == 2; // rays go on in the midst of a tile's lists
        if (isDense) set.settings.tile = set.settings.viewSize = 64, set.settings.bins = 16;
        FrameGeometry geometry;
        geometry.frame.mode = set.settings.mode;
        addSoup(random, geometry.triangles, isDense ? 20000 : 200);
        addRoom(random, geometry.triangles);
        const Grid grid = buildGrid(geometry, set.camera, set.settings);
        std::vector<Ray> rays;
        std::vector<float> maxT;
        for (int i = 0; i < kRays; ++i) {
            const auto point = [&] { return uniformPoint(random, 0.9); };
            const float size = (float) std::abs(random.wide(-2, 2));
            rays.push_back({round % 4 == 1 ? glm::vec3(0.0f) : point(), point() * size,
                            i % 5 ? kNoPrimitive : (uint32_t) random.below(200)});
            maxT.push_back((float) std::abs(random.wide(-2, 1)) / size);
        }
        std::vector<Hit> first;
        for (GlBackend* gl : {&turns, &whole}) {
            const auto [hits, occluded] = answersOf(*gl, geometry, grid, rays, maxT);
            if (first.empty()) first = hits;
            for (size_t i = 0; i < rays.size(); ++i) {
                ASSERT_TRUE(sameHit(hits[i], first[i])) << hex(rays[i]);
                const Hit expected = closestHit(grid, geometry, rays[i]);
                ++compared;
                found += expected.found();
                const bool isNear = std::abs(hits[i].t - expected.t) <= 1e-3f * expected.t;
                different += hits[i].primitive != expected.primitive || !isNear;
                different += (occluded[i] != 0) != anyHit(grid, geometry, rays[i], maxT[i]);
            }
        }
    }
    EXPECT_GT(found, compared / 4);
    EXPECT_LE(different, compared / 200);
    std::cout << different << " of " << compared << " rays differ, " << found << " hit\n";
}

/// A hit is final only where all that may be as near, as far as a float tells, has been seen.
TEST(GlTrace, GoesOnWhereTheNextTileMayHoldANearerHit) {
    GlBackend gl;
    const FlushDenormals flush;
    Random random(13);
    for (int i = 0; i < cases(100, 5000); ++i) {
        const auto [set, ray, geometry] = finalCase(random);
        gl.setGeometry(geometry);
        gl.writeGrid(buildGrid(geometry, set.camera, set.settings));
        std::vector<Hit> hits(1);
        gl.intersect(std::vector<Ray>{ray}, hits);
        const Hit expected = closestHitBruteForce(geometry, ray);
        ASSERT_EQ(hits[0].primitive, expected.primitive) << hex(ray) << " in case " << i;
        ASSERT_EQ(hits[0].t, expected.t) << hex(ray) << " in case " << i;
    }
}

/// A hit's record belongs to the first tile that may hold it, as far as a float tells.
TEST(GlTrace, FilesHitsUnderTheFirstTileThatMayHoldThem) {
    GlBackend gl;
    const FlushDenormals flush;
    Random random(14);
    for (int i = 0; i < cases(60, 5000); ++i) {
        const FiledCase c = filedCase(random);
        gl.setGeometry(c.geometry);
        gl.writeGrid(buildGrid(c.geometry, c.set.camera, c.set.settings));
        std::vector<Hit> hits(1);
        gl.intersect(std::vector<Ray>{c.ray}, hits);
        ASSERT_TRUE(hits[0].found()) << hex(c.ray) << " in case " << i;
        ASSERT_EQ((int) hits[0].tile, c.tileOf(hits[0].t)) << hex(c.ray) << " in case " << i;
    }
}

} // namespace
} // namespace dirt::test
