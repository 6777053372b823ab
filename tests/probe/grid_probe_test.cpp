// What GridProbe says, against the grid it asks and in cases known by hand.

#include "core/probe/grid_probe.h"

#include "core/base/error.h"
#include "core/trace/traverse.h"
#include "tests/support/random.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <sstream>
#include <stdexcept>

#include <gtest/gtest.h>

namespace dirt::test {
namespace {

GridSettings grid(int viewSize, int tile, int bins) {
    GridSettings settings;
    settings.viewSize = viewSize;
    settings.tile = tile;
    settings.bins = bins;
    return settings;
}

glm::vec3 randomPoint(Random& random, double size) {
    return {(float) random.uniform(-size, size), (float) random.uniform(-size, size),
            (float) random.uniform(-size, size)};
}

std::vector<WorldTriangle> randomTriangles(Random& random, int count) {
    std::vector<WorldTriangle> triangles;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 center = randomPoint(random, 3.0);
        triangles.push_back({center + randomPoint(random, 0.5), center + randomPoint(random, 0.5),
                             center + randomPoint(random, 0.5)});
    }
    return triangles;
}

const std::vector<WorldTriangle> kOne = {{{-1, -1, -2}, {1, -1, -2}, {0, 1, -2}}};

TEST(GridProbe, ABorderBelongsToBothSides) {
    const GridProbe probe(kOne, Camera{}, grid(4, 1, 1)); // borders at -1, -1/2, 0, 1/2, 1
    EXPECT_EQ(probe.tilesAt({0.25f, 0.75f, -1}), std::vector<Tile>({{5, 2, 3}}));
    EXPECT_EQ(probe.tilesAt({0.25f, 0.5f, -1}), std::vector<Tile>({{5, 2, 2}, {5, 2, 3}}));
    EXPECT_EQ(probe.tilesAt({0, 0, -1}).size(), 4u);
    // The corner of three faces: one tile of each.
    EXPECT_EQ(probe.tilesAt({1, 1, -1}), std::vector<Tile>({{0, 3, 0}, {2, 0, 3}, {5, 3, 3}}));
    EXPECT_TRUE(probe.tilesAt({0, 0, 0}).empty());
}

TEST(GridProbe, AnswersInWorldSpace) {
    Camera camera;
    camera.eye = {100, 200, 300};
    std::vector<WorldTriangle> triangles = kOne;
    for (WorldTriangle& t : triangles)
        for (glm::vec3* p : {&t.a, &t.b, &t.c}) *p = *p * 8.0f + camera.eye;
    const GridProbe probe(triangles, camera, grid(4, 1, 2));
    const glm::vec3 point = camera.eye + glm::vec3(0.25f, -0.25f, -16.0f);
    const std::vector<Cell> cells = probe.cellsAt(point);
    ASSERT_EQ(cells.size(), 1u);
    EXPECT_EQ(cells[0].tile(), (Tile{5, 2, 1}));
    EXPECT_EQ(probe.ids(cells[0]), Ids({0}));
    // One depth, rounded outwards by at most 16 ulp (G2) of 2^-23 * 16.
    EXPECT_NEAR(probe.depths(cells[0].tile()).near, 16.0f, 16 * 0x1p-23f * 16);
    const Hit hit = probe.hit(camera.eye, {0, 0, -2});
    EXPECT_EQ(hit.primitive, 0u);
    EXPECT_FLOAT_EQ(hit.t, 8.0f);
}

TEST(GridProbe, ListsEveryTriangleInTheCellsOfItsPoints) {
    Random random(1);
    for (int round = 0; round < 20; ++round) {
        const auto triangles = randomTriangles(random, 12);
        const GridProbe probe(triangles, Camera{}, grid(random.range(1, 40), 4, 5));
        for (uint32_t id = 0; id < triangles.size(); ++id) {
            const auto& t = triangles[id];
            for (int i = 0; i < 20; ++i) {
                const double u = random.uniform(), v = (1 - u) * random.uniform();
                const glm::vec3 point = t.a + (t.b - t.a) * (float) u + (t.c - t.a) * (float) v;
                for (const Tile& tile : probe.tilesAt(point)) {
                    const Ids ids = probe.ids(tile);
                    EXPECT_TRUE(std::count(ids.begin(), ids.end(), id))
                        << "triangle " << id << " in " << probe.describe(tile);
                }
            }
        }
    }
}

TEST(GridProbe, CellsOfIdsAndIdsOfCellsAreOne) {
    Random random(2);
    const auto triangles = randomTriangles(random, 9);
    const GridProbe probe(triangles, Camera{}, grid(23, 5, 3));
    size_t entries = 0;
    for (uint32_t id = 0; id < triangles.size(); ++id) {
        const std::vector<Cell> cells = probe.cellsOf(id);
        EXPECT_TRUE(std::is_sorted(cells.begin(), cells.end()));
        for (const Cell& cell : cells) {
            const Ids ids = probe.ids(cell);
            EXPECT_TRUE(std::count(ids.begin(), ids.end(), id)) << cell;
        }
        entries += cells.size();
    }
    EXPECT_EQ(entries, probe.grid().ids.size());
}

TEST(GridProbe, BinsAreThoseOfTheGridsMap) {
    Random random(3);
    const GridProbe probe(randomTriangles(random, 30), Camera{}, grid(16, 4, 8));
    int asked = 0;
    for (int view = 0; view < 6; ++view)
        for (int i = 0; i < 16; ++i) {
            const Tile tile{view, i % 4, i / 4};
            const WorldDepths range = probe.depths(tile);
            if (range.empty()) {
                EXPECT_TRUE(probe.binsBetween(tile, 0, 1e9f).empty());
                continue;
            }
            ++asked;
            EXPECT_EQ(probe.binsBetween(tile, range.near, range.near), std::vector<int>{0});
            EXPECT_EQ(probe.binsBetween(tile, range.far, range.far), std::vector<int>{7});
            EXPECT_EQ(probe.binsBetween(tile, 0, 1e9f).size(), 8u);
            EXPECT_TRUE(probe.binsBetween(tile, range.far * 1.1f, range.far * 1.2f).empty());
            EXPECT_TRUE(probe.binsBetween(tile, 0, range.near * 0.9f).empty());
        }
    EXPECT_GT(asked, 10);
}

TEST(GridProbe, ARayVisitsTheCellThatHoldsItsHit) {
    Random random(4);
    const auto triangles = randomTriangles(random, 40);
    const GridProbe probe(triangles, Camera{}, grid(32, 4, 4));
    int hits = 0;
    for (int i = 0; i < 300; ++i) {
        const glm::vec3 origin = randomPoint(random, 3), direction = randomPoint(random, 1);
        const Hit hit = probe.hit(origin, direction);
        EXPECT_EQ(
            hit.primitive,
            closestHitBruteForce(probe.geometry(), probe.gridRay(origin, direction)).primitive);
        if (!hit.found()) continue;
        ++hits;
        const int columns = probe.grid().views[hit.view].columns;
        const Tile tile{(int) hit.view, (int) hit.tile % columns, (int) hit.tile / columns};
        const std::vector<Cell> visited = probe.visited(origin, direction);
        EXPECT_TRUE(std::any_of(visited.begin(), visited.end(), [&](const Cell& cell) {
            const Ids ids = probe.ids(cell);
            return cell.tile() == tile && std::count(ids.begin(), ids.end(), hit.primitive);
        })) << tile;
    }
    EXPECT_GT(hits, 10);
}

TEST(GridProbe, SaysWhatThereIsInsteadOfWhatThereIsNot) {
    const GridProbe probe(kOne, Camera{}, grid(4, 1, 2));
    const auto textOf = [](auto&& ask) -> std::string {
        try {
            ask();
        } catch (const std::out_of_range& error) {
            return error.what();
        }
        return "nothing was thrown";
    };
    EXPECT_EQ(textOf([&] { probe.ids(Cell{6, 0, 0, 0}); }), "there is no view 6 of 6");
    EXPECT_EQ(textOf([&] { probe.ids(Tile{0, 4, 0}); }), "there is no tile (4, 0) among 4x4");
    EXPECT_EQ(textOf([&] { probe.depths(Tile{0, 0, -1}); }), "there is no tile (0, -1) among 4x4");
    EXPECT_EQ(textOf([&] { probe.ids(Cell{0, 0, 0, 2}); }), "there is no bin 2 of 2");
    EXPECT_EQ(textOf([&] { probe.cellsOf(1); }), "there is no triangle 1 of 1");
    EXPECT_EQ(textOf([&] { probe.hit({0, 0, 0}, {0, 0, -1}, 1); }), "there is no triangle 1 of 1");
}

/// What a program asks for by mistake ends in a line that says so.
TEST(GridProbe, RefusesWhatNoGridIsMadeOf) {
    const GridSettings good = grid(64, 16, 4);
    const auto textOf = [&](const auto& spoil) -> std::string {
        GridSettings settings = good;
        Camera camera;
        std::vector<WorldTriangle> triangles = kOne;
        spoil(settings, camera, triangles);
        try {
            GridProbe(triangles, camera, settings);
        } catch (const InputError& error) {
            return error.what();
        }
        return "nothing was thrown";
    };
    using Settings = GridSettings;
    using Triangles = std::vector<WorldTriangle>;
    const auto ofSettings = [&](const auto& spoil) {
        return textOf([&](Settings& settings, Camera&, Triangles&) { spoil(settings); });
    };
    EXPECT_EQ(ofSettings([](Settings&) {}), "nothing was thrown");
    EXPECT_EQ(ofSettings([](Settings& s) { s.tile = 0; }),
              "pixels of a tile: 0; there is 1 at least");
    EXPECT_EQ(ofSettings([](Settings& s) { s.tile = -3; }),
              "pixels of a tile: -3; there is 1 at least");
    EXPECT_EQ(ofSettings([](Settings& s) { s.bins = 0; }),
              "bins of a tile: 0; there is 1 at least");
    EXPECT_EQ(ofSettings([](Settings& s) { s.bins = -1; }),
              "bins of a tile: -1; there is 1 at least");
    EXPECT_EQ(ofSettings([](Settings& s) { s.width = 0; }),
              "an image width of 0; it is 1 at least");
    EXPECT_EQ(ofSettings([](Settings& s) { s.viewSize = s.height = 0; }),
              "an image height of 0; it is 1 at least");
    EXPECT_EQ(ofSettings([](Settings& s) { s.viewSize = -5; }),
              "a view size of -5; it is 1 at least, or 0 for the image's height");
    EXPECT_NE(ofSettings([](Settings& s) { s.bins = 1 << 30; }).find("cells"), std::string::npos);
    for (const auto& [size, tile] : {std::pair(1 << 30, 16), std::pair(9000, 1)})
        EXPECT_NE(ofSettings([&](Settings& s) {
                      s.viewSize = size, s.tile = tile;
                  }).find("has more than 8192 tiles a side"),
                  std::string::npos);

    const float nan = std::nanf(""), inf = std::numeric_limits<float>::infinity();
    const std::string unfit = "the scene does not fit into float32 as seen from the eye";
    EXPECT_EQ(textOf([](Settings&, Camera&, Triangles& t) { t.clear(); }),
              "there are no triangles");
    for (const float bad : {nan, inf, -inf}) {
        EXPECT_EQ(textOf([&](Settings&, Camera&, Triangles& t) { t[0].a.x = bad; }), unfit);
        EXPECT_EQ(textOf([&](Settings&, Camera& c, Triangles&) { c.eye.x = bad; }), unfit);
    }
    const auto single = [&](const auto& spoil) {
        return textOf([&](Settings& settings, Camera& camera, Triangles&) {
            settings.mode = ViewMode::single;
            spoil(camera);
        });
    };
    EXPECT_EQ(single([](Camera&) {}), "nothing was thrown");
    EXPECT_EQ(single([](Camera& c) { c.up = c.target; }), "nothing was thrown") << "any up will do";
    EXPECT_EQ(single([](Camera& c) { c.target = c.eye; }),
              "a single view needs a target that is not the eye");
    EXPECT_EQ(single([](Camera& c) { c.verticalFov = 0.0f; }),
              "a field of view of 0; it is between 0 and 180");
    EXPECT_EQ(single([](Camera& c) { c.verticalFov = 180.0f; }),
              "a field of view of 180; it is between 0 and 180");
    EXPECT_EQ(single([&](Camera& c) { c.verticalFov = nan; }),
              "a field of view of nan; it is between 0 and 180");
}

/// Numbers that are no ray's hit nothing.
TEST(GridProbe, RaysThatAreNoneHitNothing) {
    const GridProbe probe(kOne, Camera{}, grid(64, 16, 4));
    EXPECT_TRUE(probe.hit({0, 0, 0}, {0, 0, -1}).found());
    EXPECT_FALSE(probe.hit({0, 0, 0}, {0, 0, 0}).found());
    EXPECT_FALSE(probe.hit({std::nanf(""), 0, 0}, {0, 0, -1}).found());
}

TEST(GridProbe, PrintsCellsForPeople) {
    std::ostringstream text;
    text << Cell{5, 2, 1, 0} << "; " << Tile{0, 3, 4};
    EXPECT_EQ(text.str(), "view 5, tile (2, 1), bin 0; view 0, tile (3, 4)");
    EXPECT_EQ(testing::PrintToString(Cell{5, 2, 1, 0}), "view 5, tile (2, 1), bin 0");
}

} // namespace
} // namespace dirt::test
