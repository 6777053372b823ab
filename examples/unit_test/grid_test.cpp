// Unit tests of what a grid lists: the examples of docs/unit-testing.md, between marks that begin
// with "//!".

//! headers
#include <dirt/core/probe/grid_probe.h>

#include <gtest/gtest.h>

using namespace dirt;
//! end

#include <dirt/backend_cpu/cpu_backend.h>
#include <dirt/backend_cpu/thread_pool.h>
#include <dirt/core/trace/traverse.h>

namespace {

//! settings
/// Six views of 4x4 tiles around the eye at the origin, four bins a tile.
GridSettings smallGrid() {
    GridSettings settings;
    settings.viewSize = 64;
    settings.tile = 16;
    settings.bins = 4;
    return settings;
}

/// A wall at depth 4 on the far side of everything that looks along -Z, and a small triangle
/// before it, at depth 2.
const std::vector<WorldTriangle> kWallAndFlag = {
    {{-9, -9, -4}, {9, -9, -4}, {0, 18, -4}},
    {{0.1f, 0.1f, -2}, {0.3f, 0.1f, -2}, {0.1f, 0.3f, -2}},
};
//! end

//! where
TEST(Grid, ATriangleIsListedWhereItIs) {
    const GridProbe probe(kWallAndFlag, Camera{}, smallGrid());

    // A point on the flag lies in one tile, and there in the first bin: depths go from 2 to 4.
    const std::vector<Cell> cells = probe.cellsAt({0.2f, 0.15f, -2});
    ASSERT_EQ(cells.size(), 1u);
    EXPECT_EQ(probe.ids(cells[0]), Ids({1})) << probe.describe(cells[0]);
    EXPECT_EQ(cells[0].bin, 0);

    // The wall behind it is in the same tile's last bin.
    const Tile tile = cells[0].tile();
    EXPECT_EQ(probe.binsBetween(tile, 4, 4), std::vector<int>({3}));
    EXPECT_EQ(probe.ids(Cell{tile.view, tile.column, tile.row, 3}), Ids({0}))
        << probe.describe(tile);

    // The flag is listed nowhere else.
    EXPECT_EQ(probe.cellsOf(1), cells) << probe.describe();
}
//! end

//! depths
TEST(Grid, ATilesDepthsAreThoseOfWhatItLists) {
    const GridProbe probe(kWallAndFlag, Camera{}, smallGrid());
    const Tile flag = probe.tilesAlong({0.2f, 0.15f, -2}).at(0);
    EXPECT_NEAR(probe.depths(flag).near, 2.0f, 1e-6f);
    EXPECT_NEAR(probe.depths(flag).far, 4.0f, 1e-6f);

    // Nothing is behind the eye.
    const Tile behind = probe.tilesAlong({0.2f, 0.15f, 2}).at(0);
    EXPECT_TRUE(probe.depths(behind).empty()) << probe.describe(behind);
    EXPECT_EQ(probe.ids(behind), Ids());
}
//! end

//! ray
TEST(Grid, ARayVisitsTheCellOfItsHit) {
    const GridProbe probe(kWallAndFlag, Camera{}, smallGrid());
    const glm::vec3 eye(0, 0, 0), direction(0.2f, 0.15f, -2);

    const Hit hit = probe.hit(eye, direction);
    EXPECT_EQ(hit.primitive, 1u);
    EXPECT_FLOAT_EQ(hit.t, 1.0f);

    // From the eye a ray stays in one tile: its bins, near to far.
    const std::vector<Cell> visited = probe.visited(eye, direction);
    ASSERT_EQ(visited.size(), 4u);
    EXPECT_EQ(visited.front(), probe.cellsAt(direction).at(0));

    // From beside the flag it misses the flag and hits the wall.
    EXPECT_EQ(probe.hit({1, 0, 0}, {0, 0, -1}).primitive, 0u);
}
//! end

//! limits
TEST(Grid, ARayLeavesItsOwnTriangleAndEndsWhereItIsTold) {
    const GridProbe probe(kWallAndFlag, Camera{}, smallGrid());
    const glm::vec3 onFlag(0.2f, 0.15f, -2), away(0, 0, -1);

    // A ray that starts on a triangle must not hit that one.
    EXPECT_EQ(probe.hit(onFlag, away).primitive, 1u);
    EXPECT_EQ(probe.hit(onFlag, away, 1).primitive, 0u);

    // The wall is 2 behind the flag: a hit at t < 3, none at t < 2.
    EXPECT_EQ(probe.hit(onFlag, away, 1, 3.0f).primitive, 0u);
    EXPECT_EQ(probe.hit(onFlag, away, 1, 2.0f).primitive, kNoPrimitive);
}
//! end

//! describe
TEST(Grid, DescribesATile) {
    const GridProbe probe(kWallAndFlag, Camera{}, smallGrid());
    EXPECT_EQ(probe.describe(probe.tilesAlong({0.2f, 0.15f, -2}).at(0)),
              "view 5, tile (2, 2) (-Z): depth 2 to 4\n"
              "  bin 0 from 2: 1\n"
              "  bin 1 from 2.5: -\n"
              "  bin 2 from 3: -\n"
              "  bin 3 from 3.5: 0\n");
}
//! end

//! single
TEST(Grid, ACamerasViewEndsAtItsRim) {
    GridSettings settings;
    settings.mode = ViewMode::single;
    settings.width = 64;
    settings.height = 32;
    const Camera camera{{0, 1, 5}, {0, 1, 0}, {0, 1, 0}, 60.0f};
    const GridProbe probe({{{-1, 0, 0}, {1, 0, 0}, {0, 2, 0}}}, camera, settings);
    EXPECT_EQ(probe.tilesAt({0.1f, 0.9f, 0}), std::vector<Tile>({{0, 2, 1}}));
    EXPECT_TRUE(probe.tilesAt({0, 9, 0}).empty()); // above the view
    EXPECT_TRUE(probe.tilesAt({0, 1, 9}).empty()); // behind the camera
}
//! end

//! backend
TEST(Grid, ABackendListsWhatTheDefinitionLists) {
    const GridProbe expected(kWallAndFlag, Camera{}, smallGrid());

    ThreadPool threads;
    CpuBackend backend(threads);
    backend.build(expected.geometry(), Camera{}, smallGrid());

    const GridProbe built(expected.geometry(), backend.grid());
    EXPECT_EQ(built.describe(), expected.describe());
    for (uint32_t id : {0u, 1u}) EXPECT_EQ(built.cellsOf(id), expected.cellsOf(id));
}
//! end

//! oracle
TEST(Grid, ARayHitsWhatTestingEveryTriangleHits) {
    const GridProbe probe(kWallAndFlag, Camera{}, smallGrid());
    for (int i = 0; i < 100; ++i) {
        const glm::vec3 origin(0.03f * i - 1.5f, 0.1f, 1), direction(0, 0.01f * i, -3);
        const Hit oracle = closestHitBruteForce(probe.geometry(), probe.gridRay(origin, direction));
        EXPECT_EQ(probe.hit(origin, direction).primitive, oracle.primitive) << "ray " << i;
    }
}
//! end

} // namespace
