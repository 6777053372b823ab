// What the light grid lists against core's coverage, and that its bits depend on nothing else.

#include "backend_cpu/light/light_grid.h"

#include "backend_cpu/light/light_raster.h"
#include "backend_cpu/thread_pool.h"
#include "core/grid/clip.h"
#include "core/grid/coverage.h"
#include "tests/support/print.h"
#include "tests/support/simd_targets.h"
#include "tests/support/small_scenes.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstring>
#include <map>

namespace dirt::test {
namespace {

/// What one triangle is listed with, by tile.
struct Listed {
    float near;
    uint32_t box;
};
using ListedTiles = std::map<uint32_t, Listed>;

constexpr float kReach = 2.5f;
constexpr float kNearest = kReach * 0x1p-11f;

/// A square of a face.
struct Square {
    int x, y, shift;
    uint32_t node;

    bool inner() const { return (node & LightTree::kInner) != 0; }
    Square child(const LightTree& tree, int i) const {
        const int size = shift - LightTree::kSplitBits;
        return {x + ((i & 3) << size), y + ((i >> 2) << size), size,
                tree.nodes[(node & ~LightTree::kInner) + (uint32_t) i]};
    }
};

/// A light grid at the origin, with tiles on one face alone: around a column and a row of
/// \p roots, cut further by chance.
struct OneFace {
    LightGrid grid;
    int index;

    OneFace(const View& view, int roots, int column, int row, Random& random)
        : index(2 * view.axisW + (view.signW < 0.0f)) {
        grid.reach = kReach;
        grid.nearest = kNearest;
        grid.records.resize(1);
        LightTree& tree = grid.tree;
        tree.rootShift = kPlaceBits - std::countr_zero((unsigned) roots);
        LightFace& face = tree.faces[index];
        face = {view.axisX, view.axisY, view.axisW, view.signW};
        face.column = std::max(0, column - 12), face.row = std::max(0, row - 12);
        face.columns = std::min(25, roots - face.column);
        face.rows = std::min(25, roots - face.row);
        tree.nodes.resize((size_t) (face.columns * face.rows));
        for (size_t root = 0, end = tree.nodes.size(); root < end; ++root)
            split(root, tree.rootShift, random.chance(0.5) ? 0.0 : 0.1, random);
    }

    const LightFace& face() const { return grid.tree.faces[index]; }
    Square root(int column, int row) const {
        const int shift = grid.tree.rootShift;
        return {column << shift, row << shift, shift,
                grid.tree.nodes[face().firstNode + (size_t) ((row - face().row) * face().columns +
                                                             column - face().column)]};
    }

private:
    void split(size_t node, int shift, double chance, Random& random) {
        LightTree& tree = grid.tree;
        if (shift - LightTree::kSplitBits < kUnitBits || !random.chance(chance)) {
            tree.nodes[node] = tree.tiles++;
            return;
        }
        const size_t first = tree.nodes.size();
        tree.nodes[node] = LightTree::kInner | (uint32_t) first;
        tree.nodes.resize(first + 16);
        for (size_t child = 0; child < 16; ++child)
            split(first + child, shift - LightTree::kSplitBits, 0.5 * chance, random);
    }
};

/// Asks for the tiles of \p triangle: the plain way, and the way of frames.
std::array<ListedTiles, 2> listedTiles(const Triangle& triangle, OneFace& only) {
    std::array<ListedTiles, 2> listed;
    rasterFromLight(only.grid, triangle, only.face(), 0.5 * kNearest,
                    [&](uint32_t tile, float near, uint32_t box) {
                        EXPECT_TRUE(listed[0].insert({tile, {near, box}}).second) << "twice";
                    });
    FrameGeometry geometry;
    geometry.triangles = {triangle};
    LightPiece piece;
    scanFromLight(geometry, only.grid, 0, 1, piece);
    for (const LightFragment& fragment : piece.fragments)
        listed[1][fragment.tile] = {fragment.near, fragment.box};
    if (!piece.close.empty()) listed[1] = listed[0]; // in no list
    return listed;
}

/// Whether a tile of \p square is listed at no more than \p depth.
bool lists(const ListedTiles& tiles, const LightTree& tree, const Square& square, double depth) {
    if (!square.inner()) {
        const auto entry = tiles.find(square.node);
        return entry != tiles.end() && entry->second.near <= depth * (1.0 + 0x1p-18);
    }
    for (int i = 0; i < 16; ++i)
        if (lists(tiles, tree, square.child(tree, i), depth)) return true;
    return false;
}

/// Whether the place is listed: its tile, at no more than \p depth, in the box.
bool listsPlace(const ListedTiles& tiles, const LightTree& tree, Square square, int x, int y,
                double depth) {
    while (square.inner()) {
        const int size = square.shift - LightTree::kSplitBits;
        square = square.child(tree, (y - square.y) >> size << 2 | (x - square.x) >> size);
    }
    const auto entry = tiles.find(square.node);
    if (entry == tiles.end() || entry->second.near > depth * (1.0 + 0x1p-18)) return false;
    const auto byte = [&](int i) { return (int) (entry->second.box >> 8 * i & 255); };
    const int unit = square.shift - kUnitBits, last = (1 << kUnitBits) - 1;
    x = (x - square.x) >> unit, y = (y - square.y) >> unit;
    return byte(0) <= x && x <= last - byte(1) && byte(2) <= y && y <= last - byte(3);
}

/// What core's coverage lists in a root is listed in a tile of it, at a depth that is not beyond
/// core's; and where a ray may be looked up that meets a point of the triangle, the triangle is.
TEST(LightLists, HoldWhatCoreCovers) {
    Random random(83);
    uint64_t listed = 0, points = 0;
    for (const int roots : {1, 16, 128, 1024}) {
        const std::vector<ViewSet> sets{fullViews(roots, 1)};
        // The same tiles without core's guard band, which is wider than the light grid's.
        GridSettings settings = sets[0].settings;
        settings.precision = Precision::fast;
        const std::vector<View> plain = makeViews(settings, sets[0].camera);
        NastyTriangles nasty(random, sets);
        for (int round = 0; round < cases(3000, 200000); ++round) {
            const TileCase c = nasty.next();
            const View& view = plain[(size_t) (c.view - sets[0].views.data())];
            OneFace only(view, roots, c.column, c.row, random);
            const LightFace& face = only.face();
            const LightTree& tree = only.grid.tree;
            const auto ways = listedTiles(c.triangle, only);
            if (HasFailure()) return;
            ViewTriangle setup;
            if (!setUpTriangle(c.triangle, view, setup)) continue;
            for (int i = 0; i < 40; ++i) {
                const int column = face.column + random.below(face.columns);
                const int row = face.row + random.below(face.rows);
                DepthInterval depths;
                if (!overlaps(setup, view, column, row) ||
                    !clipToTile(setup, view, column, row, depths) || depths.near <= kNearest)
                    continue;
                ++listed;
                for (const ListedTiles& way : ways)
                    ASSERT_TRUE(lists(way, tree, only.root(column, row), depths.near))
                        << hex(c.triangle) << " at " << column << ", " << row << " of " << roots
                        << ", " << c.kind;
            }
            for (int i = 0; i < 10; ++i) {
                const double u = random.chance(0.3) ? 0.0 : random.uniform();
                const double v = random.chance(0.3) ? 0.0 : random.uniform() * (1.0 - u);
                const glm::dvec3 p = glm::dvec3(c.triangle.a) * (1.0 - u - v) +
                                     glm::dvec3(c.triangle.b) * u + glm::dvec3(c.triangle.c) * v;
                const double w = p[view.axisW] * view.signW;
                if (!(w > kNearest)) continue;
                // As far away as the ray's rounding and that of its place reach.
                const double away = kReach / w + 3.0;
                const auto placeOf = [&](double x) {
                    const double place = (x / w + 1.0) * kPlacesPerSlope;
                    return (int) std::clamp(std::floor(place + random.pick({-away, 0.0, away})),
                                            -1e9, 1e9);
                };
                const int x = placeOf(p[view.axisX]), y = placeOf(p[view.axisY]);
                const int column = x >> tree.rootShift, row = y >> tree.rootShift;
                if (column < face.column || column >= face.column + face.columns ||
                    row < face.row || row >= face.row + face.rows)
                    continue;
                ++points;
                for (const ListedTiles& way : ways)
                    ASSERT_TRUE(listsPlace(way, tree, only.root(column, row), x, y, w))
                        << hex(c.triangle) << " at " << x << ", " << y << " of " << roots << ", "
                        << c.kind;
            }
        }
    }
    EXPECT_GT(listed, 5000u);
    EXPECT_GT(points, 5000u);
}

/// The bits of all that rays read.
std::vector<uint32_t> bitsOf(const FrameGeometry& geometry, const LightGrid& grid) {
    std::vector<uint32_t> bits = grid.heads;
    bits.insert(bits.end(), grid.tree.nodes.begin(), grid.tree.nodes.end());
    const size_t entries = grid.heads.back();
    for (size_t i = 0; i < entries; ++i) {
        bits.insert(bits.end(), {std::bit_cast<uint32_t>(grid.near[i]), grid.box[i], grid.id[i]});
        std::array<uint32_t, sizeof(LightRecord) / sizeof(uint32_t)> record;
        std::memcpy(record.data(), &grid.records[grid.id[i]], sizeof(LightRecord));
        bits.insert(bits.end(), record.begin(), record.end());
    }
    EXPECT_EQ(grid.records.size(), geometry.triangles.size());
    bits.insert(bits.end(), grid.close.begin(), grid.close.end());
    return bits;
}

TEST(LightLists, AreTheSameForAnyNumberOfThreadsAndInstructionSet) {
    Random random(84);
    FrameGeometry geometry;
    for (int i = 0; i < 20000; ++i) {
        const glm::vec3 centre = uniformPoint(random, 1.0);
        const double size = random.chance(0.05) ? 1.0 : 0.05;
        const auto corner = [&] { return centre + uniformPoint(random, size); };
        geometry.triangles.push_back({corner(), corner(), corner()});
    }
    Spotlight light;
    light.target = glm::vec3(0.0f);
    for (const glm::vec3 position : {glm::vec3(1.5f, 1.5f, 0.0f), glm::vec3(0.3f, 0.2f, 0.1f)}) {
        light.position = position;
        light.aperture = position.x > 1.0f ? 60.0f : 360.0f;
        LightGrid serial, parallel;
        SerialExecutor one;
        fillLightGrid(geometry, light, one, serial);
        ASSERT_FALSE(serial.empty());
        const std::vector<uint32_t> expected = bitsOf(geometry, serial);
        EXPECT_GT(expected.size(), 20000u);
        for (const unsigned threads : {2u, 7u}) {
            ThreadPool pool(threads);
            fillLightGrid(geometry, light, pool, parallel);
            EXPECT_EQ(bitsOf(geometry, parallel), expected);
        }
        forEachTarget([&] {
            fillLightGrid(geometry, light, one, parallel);
            EXPECT_EQ(bitsOf(geometry, parallel), expected);
        });
    }
}

} // namespace
} // namespace dirt::test
