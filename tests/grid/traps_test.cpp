#include "core/grid/clip.h"
#include "core/grid/grid.h"
#include "core/verify/exact_clip.h"
#include "tests/support/print.h"
#include "tests/support/views.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cfloat>

// The known traps of construction, each with the case that springs it.

namespace dirt::test {
namespace {

/// Listed as in construction, and its depths.
bool listed(const Triangle& triangle, const View& view, int column, int row,
            DepthInterval& depths) {
    ViewTriangle setup;
    return setUpTriangle(triangle, view, setup) && overlaps(setup, view, column, row) &&
           clipToTile(setup, view, column, row, depths);
}

Grid gridOf(const ViewSet& set, std::vector<Triangle> triangles) {
    FrameGeometry geometry;
    geometry.triangles = std::move(triangles);
    return buildGrid(geometry, set.camera, set.settings);
}

/// A triangle of the grid frame from points of the +Z face's frame.
Triangle inPlusZ(const ViewSet& set, glm::vec3 a, glm::vec3 b, glm::vec3 c) {
    const View& view = set.views[4];
    return {fromView(view, a), fromView(view, b), fromView(view, c)};
}

// 1. The plane of this steep triangle spans the whole depth of the tile at the corner rays; the
// triangle itself takes up a thousandth of it.
TEST(Traps, ClipsTheTriangleNotItsPlane) {
    const ViewSet set = fullViews(4, 1);
    const Triangle t = inPlusZ(set, {0.125f, 0.125f, 0.5f}, {0.1251f, 0.125f, 0.5005f},
                               {0.1251f, 0.1251f, 0.5005f});
    DepthInterval depths;
    ASSERT_TRUE(listed(t, set.views[4], 2, 2, depths));
    EXPECT_LE(depths.near, 0.5f);
    EXPECT_GE(depths.near, 0.5f - 16 * 0x1p-25f);
    EXPECT_GE(depths.far, 0.5005f);
    EXPECT_LE(depths.far, 0.5005f + 16 * 0x1p-24f);
}

// 1. Edge-on: its plane holds the eye, so corner rays miss it or lie in it.
TEST(Traps, KeepsEdgeOnTriangles) {
    const ViewSet set = fullViews(4, 1);
    const Triangle t =
        inPlusZ(set, {0.125f, 0.0625f, 0.25f}, {0.25f, 0.125f, 0.5f}, {0.25f, 0.25f, 0.75f});
    const ExactTriangle exact(t, set.views[4]);
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column) {
            const ExactCone cone(set.views[4], column, row, set.tileSize(set.views[4]), 1.0 / 512);
            DepthInterval depths;
            const ExactDepths expected = clipExactly(exact, cone);
            if (expected.meets) {
                EXPECT_TRUE(listed(t, set.views[4], column, row, depths));
            }
        }
}

// 2. The polygon left by the clip begins with the same point three times over: two vertices
// coincide in the tile's corner, and the cut along its border goes through it.
TEST(Traps, SurvivesCoincidentClippedVertices) {
    const ViewSet set = fullViews(4, 1);
    const glm::vec3 corner{0.25f, 0.25f, 0.5f};
    for (const Triangle& t : {inPlusZ(set, corner, corner, {0.5f, 0.5f, 1.0f}),
                              inPlusZ(set, corner, {0.25f, 0.0f, 0.5f}, {0.75f, 0.5f, 1.0f}),
                              inPlusZ(set, corner, {0.125f, 0.125f, 0.25f}, {0.5f, 0.5f, 1.0f})})
        for (int row = 0; row < 4; ++row)
            for (int column = 0; column < 4; ++column) {
                const TileSize size = set.tileSize(set.views[4]);
                const ExactTriangle exact(t, set.views[4]);
                const ExactDepths inner =
                    clipExactly(exact, {set.views[4], column, row, size, 1.0 / 512});
                const ExactDepths outer =
                    clipExactly(exact, {set.views[4], column, row, size, 1.0 / 64});
                DepthInterval depths;
                const bool found = listed(t, set.views[4], column, row, depths);
                if (inner.meets) {
                    ASSERT_TRUE(found) << hex(t) << " " << column << " " << row;
                    EXPECT_LE(compare(depths.near, inner.near), 0);
                    EXPECT_GE(compare(depths.far, inner.far), 0);
                } else
                    EXPECT_TRUE(!found || outer.meets) << hex(t) << " " << column << " " << row;
            }
}

// 5. The same triangle at every scale: powers of two change nothing but exponents.
TEST(Traps, AbsoluteEpsilonsInCoverage) {
    const ViewSet set = fullViews(64, 1);
    const View& view = set.views[4];
    const Triangle t =
        inPlusZ(set, {0.3f, 0.21f, 1.0f}, {0.33f, 0.24f, 1.1f}, {0.31f, 0.27f, 0.9f});
    for (int exponent : {0, -20, -40, -60}) {
        const float scale = std::ldexp(1.0f, exponent);
        const Triangle scaled{t.a * scale, t.b * scale, t.c * scale};
        for (int row = 30; row < 50; ++row)
            for (int column = 30; column < 50; ++column) {
                DepthInterval depths, expected;
                ASSERT_EQ(listed(scaled, view, column, row, depths),
                          listed(t, view, column, row, expected));
                ASSERT_EQ(depths.near, expected.near * scale);
                ASSERT_EQ(depths.far, expected.far * scale);
            }
    }
}

// 5. Scenes of size 1e-6 and 1e6, and one moved by 1e6: the grid frame is the same as at size 1,
// as far as float32 holds the world positions.
TEST(Traps, AbsoluteEpsilonsInTheGridFrame) {
    Mesh mesh;
    mesh.positions = {{1, 2, 3}, {2, 2, 3}, {1, 3, 5}};
    mesh.triangles = {{0, 1, 2}};
    Camera camera;
    const Triangle expected = makeFrameGeometry(mesh, camera, ViewMode::full).triangles[0];
    for (float scale : {0x1p-20f, 0x1p20f, 0x1p-100f, 0x1p100f}) {
        Mesh scaled = mesh;
        for (glm::vec3& p : scaled.positions) p *= scale;
        const Triangle t = makeFrameGeometry(scaled, camera, ViewMode::full).triangles[0];
        EXPECT_EQ(t.a, expected.a);
        EXPECT_EQ(t.b, expected.b);
        EXPECT_EQ(t.c, expected.c);
    }
    const glm::vec3 far{0x1p20f, -0x1p20f, 0x1p19f};
    Mesh moved = mesh;
    for (glm::vec3& p : moved.positions) p += far;
    camera.eye = far;
    EXPECT_EQ(makeFrameGeometry(moved, camera, ViewMode::full).triangles[0].c, expected.c);
}

// 6. Depth bounds of zero length, one bin, a tile with one entry, one tile, one pixel, odd sizes,
// views with no geometry.
TEST(Traps, DegenerateGrids) {
    std::vector<ViewSet> sets{fullViews(1, 1), fullViews(1, 64), fullViews(17, 16),
                              singleView(1, 1, 1, 60.0f), singleView(3, 1, 2, 60.0f)};
    for (ViewSet& set : sets)
        for (int bins : {1, 2, 256}) {
            set.settings.bins = bins;
            // Of constant depth in the last view, as seen along its axis; in no other view.
            const View& view = set.views.back();
            const Triangle t{fromView(view, {0.1f, 0.1f, 0.5f}),
                             fromView(view, {0.12f, 0.1f, 0.5f}),
                             fromView(view, {0.1f, 0.12f, 0.5f})};
            const Grid grid = gridOf(set, {t});
            size_t tiles = 0;
            for (size_t v = 0; v < set.views.size(); ++v)
                for (int tile = 0; tile < set.views[v].tiles(); ++tile) {
                    const DepthBounds& bounds = grid.bounds((int) v, tile);
                    if (bounds.empty()) continue;
                    ++tiles;
                    EXPECT_EQ(v, set.views.size() - 1);
                    const BinMap bin(bounds, bins);
                    EXPECT_EQ(grid.list((int) v, tile, bin(0.5f)).size(), 1u);
                    EXPECT_EQ(grid.list((int) v, tile, bin(0.5f))[0], 0u);
                }
            EXPECT_GE(tiles, 1u) << describe(set);
        }
    for (const ViewSet& set : sets) {
        const Grid empty = gridOf(set, {});
        EXPECT_TRUE(empty.ids.empty());
        for (const DepthPyramid& pyramid : empty.pyramids)
            EXPECT_TRUE(pyramid.levels.back().bounds[0].empty());
    }
}

// 7. However many triangles share one bin, all are listed.
TEST(Traps, NothingIsDroppedWhereListsAreLong) {
    ViewSet set = fullViews(8, 8);
    set.settings.bins = 2;
    const uint32_t count = 200'000;
    const std::vector<Triangle> triangles(
        count, inPlusZ(set, {0.1f, 0.1f, 0.5f}, {0.2f, 0.1f, 0.5f}, {0.1f, 0.2f, 0.5f}));
    const Grid grid = gridOf(set, triangles);
    const BinMap bin(grid.bounds(4, 0), 2);
    const auto list = grid.list(4, 0, bin(0.5f));
    ASSERT_EQ(list.size(), count);
    for (uint32_t id = 0; id < count; ++id) ASSERT_EQ(list[id], id);
}

// 9. Zero-area and tiny triangles, far below 1/256 pixel, are listed like others.
TEST(Traps, TinyAndFlatTrianglesAreListed) {
    const ViewSet set = fullViews(512, 1);
    const View& view = set.views[4];
    const glm::vec3 p{0.1f, 0.1f, 0.5f};
    const glm::vec3 q{std::nextafter(0.1f, 1.0f), 0.1f, 0.5f},
        r{0.1f, std::nextafter(0.1f, 1.0f), 0.5f};
    for (const Triangle& t : {inPlusZ(set, p, q, r), inPlusZ(set, p, p, p), inPlusZ(set, p, q, q),
                              inPlusZ(set, p, q, {0.5f * (p.x + q.x), 0.1f, 0.5f})}) {
        DepthInterval depths;
        EXPECT_TRUE(listed(t, view, cellAt(view.s, 0.2), cellAt(view.t, 0.2), depths));
        EXPECT_FALSE(listed(t, view, cellAt(view.s, 0.2) + 2, cellAt(view.t, 0.2), depths));
    }
}

} // namespace
} // namespace dirt::test
