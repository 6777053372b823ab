#include "core/trace/traverse.h"
#include "tests/support/print.h"
#include "tests/support/random.h"
#include "tests/support/views.h"

#include <gtest/gtest.h>

// The known traps of traversal, each with the case that springs it.

namespace dirt::test {
namespace {

struct TrapScene {
    ViewSet set;
    FrameGeometry geometry;
    Grid grid;

    TrapScene(const ViewSet& set, std::vector<Triangle> triangles) : set(set) {
        geometry.triangles = std::move(triangles);
        grid = buildGrid(geometry, set.camera, set.settings);
    }
    /// Expects the hit of brute force, which must be triangle \p id.
    void expectHit(const Ray& ray, uint32_t id) const {
        const Hit expected = closestHitBruteForce(geometry, ray),
                  hit = closestHit(grid, geometry, ray);
        EXPECT_EQ(expected.primitive, id) << hex(ray);
        EXPECT_EQ(hit.primitive, id) << hex(ray) << " " << describe(set);
        EXPECT_EQ(hit.t, expected.t);
        EXPECT_TRUE(anyHit(grid, geometry, ray, std::nextafter(expected.t, 4.0f)));
    }
};

/// A triangle around (x, y, w) of the +Z face's frame, of constant depth.
Triangle patch(const ViewSet& set, float x, float y, float w, float size) {
    const View& view = set.views[set.views.size() > 1 ? 4 : 0];
    return {fromView(view, {x - size, y - size, w}), fromView(view, {x + size, y - size, w}),
            fromView(view, {x, y + size, w})};
}

ViewSet withBins(ViewSet set, int bins, Traversal traversal = Traversal::hierarchical) {
    set.settings.bins = bins;
    set.settings.traversal = traversal;
    return set;
}

// 3. A ray that passes tile corner after tile corner exactly, or beside them by one ulp; a triangle
// much smaller than a tile sits at a corner, or just across it.
TEST(Traps, SkippedCornerTiles) {
    for (Traversal traversal : {Traversal::hierarchical, Traversal::linear})
        for (int corner = 1; corner < 16; ++corner)
            for (float aside : {0.0f, 0x1p-24f, -0x1p-24f, 0x1p-20f}) {
                const ViewSet set = withBins(fullViews(16, 1), 4, traversal);
                const View& view = set.views[4];
                const float s = view.s[corner];
                const Triangle wall{fromView(view, {-4, -4, 1}), fromView(view, {8, -4, 1}),
                                    fromView(view, {-4, 8, 1})};
                const TrapScene scene(
                    set, {wall, patch(set, s * 0.5f, (s + aside) * 0.5f, 0.5f, 0x1p-18f)});
                const glm::vec3 from = fromView(view, {-0.25f, -0.25f + aside * 0.5f, 0.5f});
                const glm::vec3 target = fromView(view, {s * 0.5f, (s + aside) * 0.5f, 0.5f});
                scene.expectHit({{0, 0, 0}, target}, 1);
                scene.expectHit({from + fromView(view, {0, 0, -0x1p-3f}),
                                 target - from + fromView(view, {0, 0, 0x1p-3f})},
                                1);
            }
}

// 3. A hit exactly on the border of two tiles, views and pixels belongs to someone.
TEST(Traps, HitsOnBordersAreKept) {
    for (int tile : {1, 4, 64}) {
        const ViewSet set = withBins(fullViews(64, tile), 16);
        std::vector<Triangle> room;
        for (int axis = 0; axis < 3; ++axis)
            for (float w : {-1.0f, 1.0f}) {
                glm::vec3 p[4];
                for (int k = 0; k < 4; ++k) {
                    p[k][axis] = w;
                    p[k][(axis + 1) % 3] = k & 1 ? 1.0f : -1.0f;
                    p[k][(axis + 2) % 3] = k & 2 ? 1.0f : -1.0f;
                }
                room.push_back({p[0], p[1], p[2]});
                room.push_back({p[3], p[2], p[1]});
            }
        const TrapScene scene(set, room);
        for (const View& view : set.views)
            for (float s : view.s)
                for (float t : {view.t.front(), view.t[view.rows / 2], view.t.back()}) {
                    const Ray ray{{0, 0, 0}, fromView(view, {s, t, 1.0f})};
                    scene.expectHit(ray, closestHitBruteForce(scene.geometry, ray).primitive);
                    EXPECT_TRUE(closestHit(scene.grid, scene.geometry, ray).found());
                }
    }
}

// 4. Depths from 1e-6 to 1 within one tile, with a ray that sees them nearly edge-on: interpolating
// 1/w loses every digit of the near ones.
TEST(Traps, LargeDepthRatios) {
    for (int bins : {1, 16, 256}) {
        const ViewSet set = withBins(fullViews(8, 8), bins);
        std::vector<Triangle> triangles;
        const glm::vec3 from{1e-7f, 0.0f, 1e-6f}, to{-0.2f, 0.3f, 1.5f};
        Random random(51);
        for (int i = 0; i < 40; ++i) { // patches across the segment, ever farther
            const float f = (float) std::pow(10.0, -6.0 + i * 0.15);
            const glm::vec3 p = from + (to - from) * f;
            const float size = f * 1e-3f;
            triangles.push_back({p + glm::vec3(-size, -size, 0), p + glm::vec3(size, -size, 0),
                                 p + glm::vec3(0, size, 0)});
        }
        for (uint32_t i = 0; i < triangles.size(); ++i) {
            const TrapScene scene(set, {triangles.begin() + i, triangles.end()});
            scene.expectHit({from, to - from}, 0);
            scene.expectHit({to, from - to}, (uint32_t) (triangles.size() - 1 - i));
        }
    }
}

// 5. One scene at six scales: powers of two change the hits' t by nothing at all.
TEST(Traps, AbsoluteEpsilonsInTraversal) {
    const ViewSet set = withBins(fullViews(32, 1), 16);
    Random random(52);
    std::vector<Triangle> triangles;
    for (int i = 0; i < 50; ++i)
        triangles.push_back(patch(set, (float) random.uniform(-1, 1), (float) random.uniform(-1, 1),
                                  (float) random.uniform(0.1, 1), 0.2f));
    const TrapScene unit(set, triangles);
    for (int exponent : {-10, -20, -40, -60}) {
        const float scale = std::ldexp(1.0f, exponent);
        std::vector<Triangle> scaled;
        for (const Triangle& t : triangles)
            scaled.push_back({t.a * scale, t.b * scale, t.c * scale});
        const TrapScene scene(set, scaled);
        for (int i = 0; i < 200; ++i) {
            const glm::vec3 o{(float) random.uniform(-1, 1), (float) random.uniform(-1, 1),
                              (float) random.uniform(-1, 1)};
            const glm::vec3 d{(float) random.uniform(-1, 1), (float) random.uniform(-1, 1),
                              (float) random.uniform(-1, 1)};
            const Hit expected = closestHit(unit.grid, unit.geometry, {o, d});
            const Hit hit = closestHit(scene.grid, scene.geometry, {o * scale, d * scale});
            EXPECT_EQ(hit.primitive, expected.primitive);
            EXPECT_EQ(hit.t, expected.t);
        }
    }
}

// 6. A tile with one entry, one bin, bounds of no length, a 1x1 image.
TEST(Traps, DegenerateGridsAreTraversed) {
    for (ViewSet set : {fullViews(1, 1), fullViews(3, 2), fullViews(16, 16),
                        singleView(1, 1, 1, 60.0f), singleView(5, 3, 2, 60.0f)})
        for (int bins : {1, 2, 256}) {
            set.settings.bins = bins;
            const View& view = set.views.size() > 1 ? set.views[4] : set.views[0];
            const TrapScene scene(set, {patch(set, 0, 0, 0.5f, 0.1f)});
            scene.expectHit({{0, 0, 0}, fromView(view, {0, 0, 1})}, 0);
            scene.expectHit({fromView(view, {0, 0, 0.75f}), fromView(view, {0, 0, -1})}, 0);
            scene.expectHit(
                {fromView(view, {0.2f, 0, 0.5f + 0x1p-10f}), fromView(view, {-0.2f, 0, -0x1p-10f})},
                0);
            // In its plane: no hit, though the ray runs through its tile and its very depth.
            EXPECT_FALSE(closestHit(scene.grid, scene.geometry,
                                    {fromView(view, {0.2f, 0, 0.5f}), fromView(view, {-1, 0, 0})})
                             .found());
        }
}

// 8. Along axes, through vertices and edges, from on a surface, from a tile border, through the
// eye.
TEST(Traps, SpecialRays) {
    for (int tile : {1, 3, 16}) {
        const ViewSet set = withBins(fullViews(48, tile), 7);
        // An octahedron around the eye: every axis hits a vertex, every coordinate plane edges.
        std::vector<Triangle> octahedron;
        for (float x : {-1.0f, 1.0f})
            for (float y : {-1.0f, 1.0f})
                for (float z : {-1.0f, 1.0f})
                    octahedron.push_back({{x, 0, 0}, {0, y, 0}, {0, 0, z}});
        const TrapScene scene(set, octahedron);
        std::vector<Ray> rays;
        for (int axis = 0; axis < 3; ++axis)
            for (float side : {-1.0f, 1.0f}) {
                glm::vec3 d(0.0f), e(0.0f);
                d[axis] = side;
                e[(axis + 1) % 3] = 0.5f;
                rays.push_back({glm::vec3(0.0f), d}); // from the eye, at a vertex
                rays.push_back({-0.5f * d, d});       // through the eye
                rays.push_back({-2.0f * d, d});       // from outside, through a vertex and the eye
                rays.push_back({d, -d});              // from on a vertex
                rays.push_back(
                    {0.5f * d + e,
                     -d - 2.0f * e});   // from the middle of an edge, through the eye's side
                rays.push_back({e, d}); // along an axis, at an edge, along view borders
                rays.push_back(
                    {glm::vec3(0.0f), d + 2.0f * e});  // along two views' border, at an edge
                rays.push_back({glm::vec3(0.25f), d}); // from a corner of views, along an axis
                rays.push_back({0.125f * d, d + glm::vec3(0x1p-30f)});
            }
        for (const Ray& ray : rays) {
            const Hit expected = closestHitBruteForce(scene.geometry, ray);
            ASSERT_TRUE(expected.found()) << hex(ray);
            scene.expectHit(ray, expected.primitive);
        }
    }
}

} // namespace
} // namespace dirt::test
