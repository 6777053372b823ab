#include "core/base/error.h"
#include "core/grid/clip.h"
#include "core/grid/grid.h"
#include "tests/support/exact_point.h"
#include "tests/support/print.h"
#include "tests/support/small_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cfloat>
#include <map>

// The structure itself: bins, pyramid, and what buildGrid lists, tile by tile.

namespace dirt::test {
namespace {

DepthBounds randomBounds(Random& random) {
    const float a = (float) std::abs(random.wide(-12, 1)),
                b = (float) std::abs(random.wide(-12, 1));
    switch (random.below(7)) {
    case 0:
        return {a, a};
    case 1:
        return {a, std::nextafter(a, FLT_MAX)};
    case 2:
        return {0.0f, b};
    case 3:
        return {0.0f, random.pick({FLT_MIN, 0x1p-149f, FLT_MAX, 0x1p-125f})};
    case 4:
        return {FLT_MIN, std::nextafter(FLT_MIN, 1.0f)};
    case 5:
        return {a, FLT_MAX};
    default:
        return {std::min(a, b), std::max(a, b)};
    }
}

TEST(BinMap, IsMonotoneAndInRangeForAllBounds) {
    Random random(31);
    for (int i = 0; i < cases(20'000, 200'000); ++i) {
        const DepthBounds bounds = randomBounds(random);
        const int bins = random.pick({1, 2, 3, 16, 44, 255, 256});
        const BinMap bin(bounds, bins);
        ASSERT_LE(bin.scale, FLT_MAX);
        std::vector<float> depths{0.0f,
                                  FLT_MIN,
                                  FLT_MAX,
                                  bounds.near,
                                  bounds.far,
                                  std::nextafter(bounds.near, 0.0f),
                                  std::nextafter(bounds.near, FLT_MAX),
                                  std::nextafter(bounds.far, 0.0f),
                                  std::nextafter(bounds.far, FLT_MAX)};
        for (int k = 0; k < 30; ++k) {
            depths.push_back(bounds.near + (float) random.uniform() * (bounds.far - bounds.near));
            depths.push_back((float) std::abs(random.wide(-30, 30)));
            depths.push_back(std::nextafter(depths[depths.size() - 2], FLT_MAX));
        }
        std::sort(depths.begin(), depths.end());
        int last = 0;
        for (float w : depths) {
            const int b = bin(w);
            ASSERT_TRUE(b >= last && b < bins)
                << hex(bounds.near) << " " << hex(bounds.far) << " " << hex(w);
            last = b;
        }
        ASSERT_EQ(bin(bounds.near), 0);
        ASSERT_GE(bin(bounds.far), bin.scale > 0.0f ? bins - 1 : 0);
    }
}

TEST(BinMap, FillsItsBins) {
    for (int bins : {1, 2, 16, 44, 256}) {
        const BinMap bin({1.0f, 2.0f}, bins);
        for (int b = 0; b < bins; ++b) EXPECT_EQ(bin(1.0f + (b + 0.5f) / bins), b);
        EXPECT_EQ(bin(2.0f), bins - 1);
    }
}

TEST(Pyramid, HoldsTheExactBoundsOfItsTiles) {
    Random random(32);
    for (int i = 0; i < 200; ++i) {
        DepthPyramid pyramid;
        DepthPyramid::Level base{random.range(1, 40), random.range(1, 40), {}};
        for (int k = 0; k < base.columns * base.rows; ++k)
            base.bounds.push_back(random.chance(0.3) ? DepthBounds{} : randomBounds(random));
        pyramid.levels.push_back(base);
        buildPyramid(pyramid);
        ASSERT_EQ(pyramid.levels.back().columns * pyramid.levels.back().rows, 1);
        for (size_t l = 0; l < pyramid.levels.size(); ++l) {
            const DepthPyramid::Level& level = pyramid.levels[l];
            const int size = 1 << l;
            ASSERT_EQ(level.columns, (base.columns + size - 1) / size);
            ASSERT_EQ(level.rows, (base.rows + size - 1) / size);
            ASSERT_EQ(level.bounds.size(), (size_t) level.columns * level.rows);
            for (int r = 0; r < level.rows; ++r)
                for (int c = 0; c < level.columns; ++c) {
                    DepthBounds expected;
                    for (int y = r * size; y < std::min((r + 1) * size, base.rows); ++y)
                        for (int x = c * size; x < std::min((c + 1) * size, base.columns); ++x)
                            if (!base.at(x, y).empty())
                                expected.include(base.at(x, y).near, base.at(x, y).far);
                    ASSERT_EQ(level.at(c, r).near, expected.near);
                    ASSERT_EQ(level.at(c, r).far, expected.far);
                }
        }
    }
}

TEST(Views, BordersSpanTheViewInOrder) {
    Random random(33);
    for (const ViewSet& set : variousViews(random)) {
        ASSERT_EQ(set.views.size(), set.settings.mode == ViewMode::full ? 6u : 1u);
        for (const View& view : set.views) {
            ASSERT_EQ(view.s.size(), (size_t) view.columns + 1);
            ASSERT_EQ(view.t.size(), (size_t) view.rows + 1);
            ASSERT_EQ(view.columns, (view.width + set.settings.tile - 1) / set.settings.tile);
            for (const auto* borders : {&view.s, &view.t}) {
                ASSERT_TRUE(std::is_sorted(borders->begin(), borders->end(), std::less_equal<>()))
                    << describe(set);
                ASSERT_EQ(borders->front(), -borders->back());
                if (set.settings.mode == ViewMode::full) {
                    ASSERT_EQ(borders->back(), 1.0f);
                }
            }
        }
    }
    EXPECT_THROW(fullViews(8193, 1), InputError);
    EXPECT_THROW(singleView(8193, 1, 1, 45.0f), InputError);
}

ViewSet smallSettings(Random& random) {
    ViewSet set = random.chance(0.6)
                      ? fullViews(random.pick({1, 2, 3, 7, 16, 21}), random.pick({1, 1, 2, 5}))
                      : singleView(random.range(1, 30), random.range(1, 30), random.pick({1, 2, 7}),
                                   random.pick({1.0f, 60.0f, 170.0f}));
    set.settings.bins = random.pick({1, 2, 16, 44});
    return set;
}

/// Every tile against every triangle, without tileRange.
TEST(BuildGrid, ListsWhatTheTilesAskFor) {
    Random random(34);
    for (int round = 0; round < cases(60, 600); ++round) {
        const ViewSet set = smallSettings(random);
        FrameGeometry geometry;
        geometry.triangles = smallScene(random, set);
        const Grid grid = buildGrid(geometry, set.camera, set.settings);
        ASSERT_EQ(grid.heads.size(), (size_t) grid.firstTile.back() * set.settings.bins + 1);
        ASSERT_EQ(grid.heads.front(), 0u);
        ASSERT_EQ(grid.heads.back(), grid.ids.size());
        ASSERT_TRUE(std::is_sorted(grid.heads.begin(), grid.heads.end()));

        size_t entries = 0;
        for (size_t v = 0; v < set.views.size(); ++v)
            for (int tile = 0; tile < set.views[v].tiles(); ++tile) {
                const View& view = set.views[v];
                std::map<uint32_t, DepthInterval> listed;
                DepthBounds expected;
                for (uint32_t id = 0; id < geometry.triangles.size(); ++id) {
                    ViewTriangle setup;
                    DepthInterval depths;
                    const int column = tile % view.columns, row = tile / view.columns;
                    if (!setUpTriangle(geometry.triangles[id], view, setup) ||
                        !overlaps(setup, view, column, row) ||
                        !clipToTile(setup, view, column, row, depths))
                        continue;
                    listed[id] = depths;
                    expected.include(depths.near, depths.far);
                }
                const DepthBounds& bounds = grid.bounds((int) v, tile);
                ASSERT_EQ(bounds.near, expected.near)
                    << describe(set) << " view " << v << " tile " << tile;
                ASSERT_EQ(bounds.far, expected.far)
                    << describe(set) << " view " << v << " tile " << tile;
                const BinMap bin(bounds, set.settings.bins);
                for (int b = 0; b < set.settings.bins; ++b) {
                    std::vector<uint32_t> ids;
                    for (const auto& [id, depths] : listed)
                        if (bin(depths.near) <= b && b <= bin(depths.far)) ids.push_back(id);
                    const auto list = grid.list((int) v, tile, b);
                    ASSERT_TRUE(std::equal(list.begin(), list.end(), ids.begin(), ids.end()))
                        << describe(set) << " view " << v << " tile " << tile << " bin " << b;
                    entries += ids.size();
                }
            }
        ASSERT_EQ(entries, grid.ids.size());
    }
}

/// G1 over the whole of construction: a point of a triangle is found in a list, wherever it lies.
TEST(BuildGrid, ListsEveryPointOfEveryTriangle) {
    Random random(35);
    long points = 0;
    for (int round = 0; round < cases(60, 600); ++round) {
        ViewSet set = smallSettings(random);
        FrameGeometry geometry;
        geometry.triangles = smallScene(random, set);
        const Grid grid = buildGrid(geometry, set.camera, set.settings);
        for (int i = 0; i < 300; ++i) {
            const uint32_t id = (uint32_t) random.below((int) geometry.triangles.size());
            const Triangle& t = geometry.triangles[id];
            const int unit =
                std::min({lowestExponent(t.a), lowestExponent(t.b), lowestExponent(t.c), 0});
            // Integer weights that add up to 2^shift: an exact point, now and then very near a
            // vertex.
            const int shift = random.range(0, 60);
            const Integer one = Integer(1) << shift;
            const Integer u = Integer(random.bits()) % (one + 1),
                          v = Integer(random.bits()) % (one - u + 1);
            const IntegerVector p = toIntegers(t.a, unit) * Integer(one - u - v) +
                                    toIntegers(t.b, unit) * u + toIntegers(t.c, unit) * v;
            for (size_t k = 0; k < set.views.size(); ++k) {
                const View& view = set.views[k];
                const IntegerVector q = ExactRay::toView(view, p);
                tilesAround(view, set.tileSize(view), q, 1.0 / 512, [&](int tile) {
                    ++points;
                    const Fraction depth{q.z, one, unit};
                    const BinMap bin(grid.bounds((int) k, tile), set.settings.bins);
                    for (float w : {floatBelow(depth), floatAbove(depth)}) {
                        const auto list = grid.list((int) k, tile, bin(w));
                        EXPECT_TRUE(std::binary_search(list.begin(), list.end(), id))
                            << hex(t) << " " << describe(set) << " view " << k << " tile " << tile
                            << " bin " << bin(w);
                    }
                });
            }
        }
    }
    EXPECT_GT(points, 5000);
}

TEST(FrameGeometry, ScalesByAPowerOfTwo) {
    Random random(36);
    for (int i = 0; i < 2000; ++i) {
        Mesh mesh;
        const double size = std::abs(random.wide(-6, 6));
        for (int k = 0; k < 6; ++k) mesh.positions.push_back(uniformPoint(random, size));
        mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
        Camera camera;
        camera.eye = uniformPoint(random, size);
        const FrameGeometry geometry = makeFrameGeometry(mesh, camera, ViewMode::full);
        float largest = 0;
        for (const Triangle& t : geometry.triangles)
            for (const glm::vec3& p : {t.a, t.b, t.c})
                for (int k = 0; k < 3; ++k) largest = std::max(largest, std::abs(p[k]));
        ASSERT_GE(largest, 1.0f);
        ASSERT_LT(largest, 2.0f);
        int exponent;
        ASSERT_EQ(std::frexp(geometry.frame.scale, &exponent), 0.5f);
        const glm::vec3 p = (mesh.positions[1] - camera.eye) * geometry.frame.scale;
        ASSERT_EQ(geometry.triangles[0].b, p);
    }
}

} // namespace
} // namespace dirt::test
