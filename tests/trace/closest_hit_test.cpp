#include "backend_cpu/cpu_backend.h"
#include "core/trace/intersect.h"
#include "core/trace/traverse.h"
#include "core/trace/view_cone.h"
#include "shaders/shared/margins.h"
#include "tests/support/border_rays.h"
#include "tests/support/exact_point.h"
#include "tests/support/exact_ray.h"
#include "tests/support/final_hits.h"
#include "tests/support/grid_rays.h"
#include "tests/support/print.h"
#include "tests/support/same_hit.h"
#include "tests/support/small_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cfloat>
#include <map>
#include <string>

#include <glm/geometric.hpp>

// T3, T5 and T7: the grid finds the hits of brute force, to the bit, whatever its settings.

namespace dirt::test {
namespace {

ViewSet randomSettings(Random& random, ViewMode mode) {
    GridSettings settings;
    settings.mode = mode;
    settings.tile = random.pick({1, 1, 2, 4, 7, 16, 64});
    const int tiles = random.pick({1, 2, 3, 8, 17, 32, 64});
    settings.viewSize = std::max(1, tiles * settings.tile - random.below(settings.tile));
    settings.width = settings.viewSize + random.below(40);
    settings.height = settings.viewSize;
    settings.bins = random.pick({1, 2, 16, 44, 256});
    settings.maxMip = random.range(-1, 7);
    settings.traversal = random.chance(0.3) ? Traversal::linear : Traversal::hierarchical;
    Camera camera;
    camera.verticalFov = random.pick({1.0f, 30.0f, 90.0f, 150.0f, 170.0f});
    return {settings, camera};
}

std::string rayText(const ViewSet& set, const std::vector<Triangle>& scene, const GridRay& r) {
    std::string text = test::describe(set) + " bins " + std::to_string(set.settings.bins) +
                       " maxMip " + std::to_string(set.settings.maxMip) +
                       (set.settings.traversal == Traversal::linear ? " linear" : " hierarchical") +
                       "\n" + hex(r.ray) + " (" + r.kind + ")\n" + std::to_string(scene.size()) +
                       " triangles";
    return text;
}

std::string text(const Hit& hit, const std::vector<Triangle>& scene) {
    if (!hit.found()) return "nothing";
    return std::to_string(hit.primitive) + " at t " + hex(hit.t) + " u " + hex(hit.u) + " v " +
           hex(hit.v) + " in view " + std::to_string(hit.view) + " tile " +
           std::to_string(hit.tile) + " " + hex(scene[hit.primitive]);
}

/// The exact hit point, times a positive factor, in units of \p ray's.
IntegerVector hitPoint(const ExactRay& ray, const Fraction& t) {
    const int tUnit = ray.unit - ray.directionUnit;
    ExactRay::Parameter parameter{t.numerator, t.denominator};
    if (t.exponent > tUnit)
        parameter.numerator <<= t.exponent - tUnit;
    else
        parameter.denominator <<= tUnit - t.exponent;
    return ray.at(parameter);
}

/// Whether the exact ray meets \p triangle in the eye, the one point that no tile holds.
bool hitsTheEye(const Ray& ray, const Triangle& triangle) {
    const ExactHit hit = intersectExactly(ray, triangle);
    return hit.hit && hitPoint(ExactRay(ray), hit.t).isZero();
}

bool insideView(const ViewSet& set, const IntegerVector& p, double widened) {
    bool inside = false;
    for (const View& view : set.views)
        tilesAround(view, set.tileSize(view), ExactRay::toView(view, p), widened,
                    [&](int) { inside = true; });
    return inside;
}

/// Whether a hit's parameter, uncertain by twice its bound, lies where the ray is inside \p cone.
bool isInside(const ExactRay& ray, const View& view, const ExactCone& cone, float t) {
    const ParameterSpan span = spanInside(ray, view, cone);
    return span.from <= t * (1.0 + 0x1p-22) && t * (1.0 - 0x1p-22) <= span.to;
}

/// The cell a hit is filed under: the ray is in it, or in its guard band, at t; and it lists the
/// primitive, so that fetch finds it.
std::string misfiled(const Grid& grid, const ViewSet& set, const ExactRay& ray, const Hit& hit) {
    const View& view = set.views[hit.view];
    const int column = (int) hit.tile % view.columns, row = (int) hit.tile / view.columns;
    if (!isInside(ray, view, ExactCone(view, column, row, set.tileSize(view), 1.0 / 64), hit.t))
        return "the hit's tile does not hold it";
    for (int bin = 0; bin < set.settings.bins; ++bin) {
        const auto list = grid.list((int) hit.view, (int) hit.tile, bin);
        if (std::binary_search(list.begin(), list.end(), hit.primitive)) return "";
    }
    return "the hit's tile does not list it";
}

class Failures {
public:
    bool add(const std::string& what) { return ++counts_[what] <= 2; }
    ~Failures() {
        for (const auto& [what, count] : counts_) ADD_FAILURE() << count << " times " << what;
    }

private:
    std::map<std::string, int> counts_;
};

TEST(ClosestHit, EqualsBruteForceInFullMode) {
    Random random(21);
    Failures failures;
    int hits = 0, total = 0;
    for (int round = 0; round < cases(150, 1500); ++round) {
        const ViewSet set = randomSettings(random, ViewMode::full);
        FrameGeometry geometry;
        geometry.triangles = smallScene(random, set);
        const Grid grid = buildGrid(geometry, set.camera, set.settings);
        GridRays rays(random, set, geometry.triangles);
        for (int i = 0; i < 250; ++i) {
            GridRay r = rays.next();
            if (random.chance(0.1))
                r.ray.skip = (uint32_t) random.below((int) geometry.triangles.size());
            const Hit expected = closestHitBruteForce(geometry, r.ray);
            if (expected.found() && hitsTheEye(r.ray, geometry.triangles[expected.primitive]))
                continue;
            const Hit hit = closestHit(grid, geometry, r.ray);
            ++total;
            hits += hit.found();
            if (!sameHit(hit, expected) && failures.add(std::string("another hit, rays ") + r.kind))
                ADD_FAILURE() << "expected " << text(expected, geometry.triangles) << "\ngot "
                              << text(hit, geometry.triangles) << "\n"
                              << rayText(set, geometry.triangles, r);
            if (hit.found() && hit.t > 0 && i % 8 == 0) {
                const std::string wrong = misfiled(grid, set, ExactRay(r.ray), hit);
                if (!wrong.empty() && failures.add(wrong + ", rays " + r.kind))
                    ADD_FAILURE() << wrong << ": " << text(hit, geometry.triangles) << "\n"
                                  << rayText(set, geometry.triangles, r);
            }
            const float maxT = random.pick(
                {expected.t, std::nextafter(expected.t, INFINITY), FLT_MAX, 0.5f, 0.0f});
            if (anyHit(grid, geometry, r.ray, maxT) != (expected.found() && expected.t < maxT) &&
                failures.add(std::string("anyHit, rays ") + r.kind))
                ADD_FAILURE() << "anyHit up to " << hex(maxT) << " differs from "
                              << text(expected, geometry.triangles) << "\n"
                              << rayText(set, geometry.triangles, r);
        }
    }
    EXPECT_GT(hits, total / 5);
}

/// Of rays that start inside the view, up to where they leave it: nothing is found beyond.
TEST(ClosestHit, EqualsBruteForceInsideASingleView) {
    Random random(22);
    Failures failures;
    int compared = 0;
    for (int round = 0; round < cases(150, 1000); ++round) {
        const ViewSet set = randomSettings(random, ViewMode::single);
        const ViewCone cone(set.views[0]);
        FrameGeometry geometry;
        geometry.triangles = smallScene(random, set);
        const Grid grid = buildGrid(geometry, set.camera, set.settings);
        GridRays rays(random, set, geometry.triangles);
        for (int i = 0; i < 250; ++i) {
            const GridRay r = rays.next();
            if (!insideView(set, ExactRay(r.ray).origin, 0.0)) continue;
            const Hit hit = closestHit(grid, geometry, r.ray);
            Hit expected = closestHitBruteForce(geometry, r.ray);
            const ViewCone::Part part = cone.part(r.ray);
            if (!part.holds(expected.t)) expected = Hit{};
            compared += expected.found();
            if (!sameHit(hit, expected) && failures.add(std::string("another hit, rays ") + r.kind))
                ADD_FAILURE() << "expected " << text(expected, geometry.triangles) << "\ngot "
                              << text(hit, geometry.triangles) << "\nleaves at " << hex(part.end)
                              << "\n"
                              << rayText(set, geometry.triangles, r);
        }
    }
    EXPECT_GT(compared, 1000);
}

TEST(ClosestHit, IsTheSameForEverySetting) {
    Random random(23);
    for (int round = 0; round < cases(10, 100); ++round) {
        ViewSet set = randomSettings(random, ViewMode::full);
        FrameGeometry geometry;
        geometry.triangles = smallScene(random, set);
        std::vector<Grid> grids;
        for (int maxMip = -1; maxMip < 7; ++maxMip) {
            set.settings.maxMip = maxMip;
            set.settings.traversal = Traversal::hierarchical;
            grids.push_back(buildGrid(geometry, set.camera, set.settings));
        }
        set.settings.traversal = Traversal::linear;
        grids.push_back(buildGrid(geometry, set.camera, set.settings));
        GridRays rays(random, set, geometry.triangles);
        for (int i = 0; i < 200; ++i) {
            const GridRay r = rays.next();
            const Hit first = closestHit(grids[0], geometry, r.ray);
            for (const Grid& grid : grids) {
                const Hit hit = closestHit(grid, geometry, r.ray);
                ASSERT_TRUE(sameHit(hit, first)) << rayText(set, geometry.triangles, r);
                ASSERT_EQ(hit.view, first.view) << rayText(set, geometry.triangles, r);
                ASSERT_EQ(hit.tile, first.tile) << rayText(set, geometry.triangles, r);
            }
        }
    }
}

/// A wall, and two triangles that hold the eye: in their midst, and at a vertex.
FrameGeometry aroundTheEye() {
    FrameGeometry geometry;
    geometry.triangles = {{{-1, -1, 0.5f}, {1, -1, 0.5f}, {0, 1, 0.5f}},
                          {{-1, 0, -1}, {1, 0, -1}, {0, 0, 1}},
                          {{0, 0, 0}, {0.5f, 0.25f, 0}, {0.5f, 0.5f, 0}}};
    return geometry;
}

/// The eye belongs to every cone's border and to no tile, and yet is a point of rays and triangles.
TEST(ClosestHit, HitsATriangleThatHoldsTheEye) {
    const FrameGeometry geometry = aroundTheEye();
    const ViewSet set = fullViews(16, 4);
    const Grid grid = buildGrid(geometry, set.camera, set.settings);
    for (const Ray& ray :
         {Ray{{0, -0.5f, 0}, {0, 1, 0}}, {{-0.125f, -0.25f, 0.375f}, {0.125f, 0.25f, -0.375f}}}) {
        const Hit expected = closestHitBruteForce(geometry, ray);
        EXPECT_EQ(expected.primitive, 1u);
        EXPECT_TRUE(sameHit(closestHit(grid, geometry, ray), expected)) << hex(ray);
        EXPECT_TRUE(anyHit(grid, geometry, ray, 2.0f)) << hex(ray);
    }
}

/// A camera that stands on a floor sees what is beyond.
TEST(ClosestHit, SeesThroughWhatHoldsTheEyeFromThere) {
    const FrameGeometry geometry = aroundTheEye();
    const ViewSet set = fullViews(16, 4);
    const Grid grid = buildGrid(geometry, set.camera, set.settings);
    for (const Ray& ray :
         {Ray{{0, 0, 0}, {0, 0.1f, 1}}, {{0, 0, 0}, {0, 0, 1}}, {{0, -0.0f, 0}, {0, -0.1f, 1}}}) {
        EXPECT_EQ(closestHitBruteForce(geometry, ray).primitive, 0u);
        EXPECT_EQ(closestHit(grid, geometry, ray).primitive, 0u) << hex(ray);
        EXPECT_FALSE(anyHit(grid, geometry, ray, 0.25f)) << hex(ray);
    }
}

TEST(ClosestHit, RaysThatAreNoneHitNothing) {
    FrameGeometry geometry;
    geometry.triangles = {{{-1, -1, 0.5f}, {1, -1, 0.5f}, {0, 1, 0.5f}}};
    const ViewSet set = fullViews(16, 4);
    const Grid grid = buildGrid(geometry, set.camera, set.settings);
    for (float bad : {std::nanf(""), INFINITY, -INFINITY})
        for (int i = 0; i < 6; ++i) {
            Ray ray{{0, 0, 0}, {0, 0, 1}};
            (i < 3 ? ray.origin : ray.direction)[i % 3] = bad;
            TraversalCounts counts;
            EXPECT_FALSE(closestHit(grid, geometry, ray, &counts).found());
            EXPECT_FALSE(anyHit(grid, geometry, ray, FLT_MAX, &counts));
            EXPECT_FALSE(closestHitBruteForce(geometry, ray).found());
            EXPECT_EQ(counts.tests, 0u);
        }
    EXPECT_FALSE(closestHit(grid, geometry, {{0, 0, 0}, {0, 0, 0}}).found());
    EXPECT_FALSE(anyHit(grid, geometry, {{0, 0, 0}, {0, 0, 1}}, std::nanf("")));
}

/// Small triangles in the way of rays along a border of which doubles cannot tell when they cross
/// it: none is missed, whichever tile lists it.
TEST(ClosestHit, FindsWhatLiesBesideABorder) {
    Random random(12);
    SerialExecutor executor;
    CpuBackend cpu(executor);
    int found = 0;
    for (int i = 0; i < cases(400, 20000); ++i) {
        const auto [set, ray, geometry] = borderCase(random);
        const Grid grid = buildGrid(geometry, set.camera, set.settings);
        const Hit expected = closestHitBruteForce(geometry, ray);
        const Hit hit = closestHit(grid, geometry, ray);
        ASSERT_EQ(hit.primitive, expected.primitive) << hex(ray) << " in case " << i;
        cpu.setGeometry(geometry);
        cpu.writeGrid(grid);
        std::vector<Hit> hits(1);
        cpu.intersect(std::vector<Ray>{ray}, hits);
        ASSERT_EQ(hits[0].primitive, expected.primitive) << hex(ray) << " in case " << i;
        found += expected.found();
    }
    EXPECT_GT(found, 100);
}

/// A hit is final only where all that may be as near, as far as a float tells, has been seen.
TEST(ClosestHit, GoesOnWhereTheNextTileMayHoldANearerHit) {
    Random random(13);
    int second = 0;
    for (int i = 0; i < cases(300, 20000); ++i) {
        const auto [set, ray, geometry] = finalCase(random);
        const Grid grid = buildGrid(geometry, set.camera, set.settings);
        const Hit expected = closestHitBruteForce(geometry, ray);
        const Hit hit = closestHit(grid, geometry, ray);
        ASSERT_TRUE(sameHit(hit, expected)) << text(hit, geometry.triangles) << ", not "
                                            << text(expected, geometry.triangles) << "\n"
                                            << hex(ray) << " in case " << i;
        TriangleHit nearer, farther;
        second += intersect(ray, geometry.triangles[0], nearer) &&
                  intersect(ray, geometry.triangles[1], farther) && nearer.t == farther.t;
    }
    EXPECT_GT(second, 50);
}

/// A hit's record belongs to the first tile that may hold it, as far as a float tells.
TEST(ClosestHit, IsFiledUnderTheFirstTileThatMayHoldIt) {
    Random random(14);
    int before = 0, behind = 0;
    for (int i = 0; i < cases(300, 20000); ++i) {
        const FiledCase c = filedCase(random);
        const Grid grid = buildGrid(c.geometry, c.set.camera, c.set.settings);
        const Hit hit = closestHit(grid, c.geometry, c.ray);
        ASSERT_TRUE(hit.found()) << hex(c.ray) << " in case " << i;
        ASSERT_EQ((int) hit.tile, c.tileOf(hit.t)) << hex(c.ray) << " in case " << i;
        // By more than one rounding, and by more than err(t).
        before += (int) hit.tile == c.before && hit.t * (1.0 - 1.125 * 0x1p-24) > c.border;
        behind += (int) hit.tile == c.behind;
    }
    EXPECT_GT(before, 20);
    EXPECT_GT(behind, 20);
}

} // namespace
} // namespace dirt::test
