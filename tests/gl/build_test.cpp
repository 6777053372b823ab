// The structure built in GLSL against the definition in core, bit for bit: any tile size, bin count
// and view, any size of the pool, and triangles that are made to go wrong.

#include "backend_gl/gl_backend.h"
#include "core/base/error.h"
#include "tests/gl/grids.h"
#include "tests/support/corner_triangles.h"
#include "tests/support/small_scenes.h"

#include <gtest/gtest.h>

namespace dirt::test {
namespace {

/// One context for all tests: starting a driver takes a while.
GlBackend& sharedBackend() {
    static GlBackend backend;
    return backend;
}

Grid build(Backend& backend, const FrameGeometry& geometry, const ViewSet& set) {
    backend.build(geometry, set.camera, set.settings);
    return backend.readGrid();
}

FrameGeometry geometryOf(std::vector<Triangle> triangles, const ViewSet& set) {
    FrameGeometry geometry;
    geometry.frame.mode = set.settings.mode;
    geometry.triangles = std::move(triangles);
    return geometry;
}

/// Views small enough for a software driver.
std::vector<ViewSet> someViews(Random& random) {
    std::vector<ViewSet> sets;
    for (int size : {1, 2, 3, 7, 33, 64}) sets.push_back(fullViews(size, 1));
    for (int tile : {3, 16, 64}) sets.push_back(fullViews(random.range(1, 700), tile));
    for (float fov : {1.0f, 45.0f, 90.0f, 170.0f})
        sets.push_back(singleView(random.range(1, 300), random.range(1, 300),
                                  random.pick({1, 2, 4, 16, 63}), fov));
    sets.push_back(singleView(8192, 3, 1, 53.0f));
    sets.push_back(singleView(1, 1, 1, 53.0f));
    for (ViewSet& set : sets) set.settings.bins = random.pick({1, 2, 16, 44, 256});
    return sets;
}

TEST(GlBuild, EqualsTheDefinitionOnNastyTriangles) {
    Random random(1);
    for (int round = 0; round < cases(1, 20); ++round)
        for (const ViewSet& set : someViews(random)) {
            const std::vector<ViewSet> one{set};
            NastyTriangles nasty(random, one);
            std::vector<Triangle> triangles;
            for (int i = 0; i < 300; ++i) triangles.push_back(nasty.next().triangle);
            const FrameGeometry geometry = geometryOf(std::move(triangles), set);
            ASSERT_TRUE(sameGrid(buildGrid(geometry, set.camera, set.settings),
                                 build(sharedBackend(), geometry, set)))
                << describe(set) << ", " << set.settings.bins << " bins, round " << round;
        }
}

TEST(GlBuild, EqualsTheDefinitionOnSmallScenes) {
    Random random(2);
    for (int round = 0; round < cases(1, 100); ++round)
        for (const ViewSet& set : someViews(random)) {
            const FrameGeometry geometry = geometryOf(smallScene(random, set), set);
            ASSERT_TRUE(sameGrid(buildGrid(geometry, set.camera, set.settings),
                                 build(sharedBackend(), geometry, set)))
                << describe(set) << ", " << set.settings.bins << " bins, round " << round;
        }
}

TEST(GlBuild, EqualsTheDefinitionOnEdgesThroughCorners) {
    Random random(8);
    for (int round = 0; round < cases(4, 100); ++round) {
        const ViewSet set = fullViews(random.range(4, 40), random.pick({1, 3}));
        std::vector<Triangle> triangles;
        for (int i = 0; i < 300; ++i)
            triangles.push_back(
                throughCorner(random, set.views[(size_t) random.below(6)]).triangle);
        const FrameGeometry geometry = geometryOf(std::move(triangles), set);
        ASSERT_TRUE(sameGrid(buildGrid(geometry, set.camera, set.settings),
                             build(sharedBackend(), geometry, set)))
            << describe(set) << ", round " << round;
    }
}

TEST(GlBuild, GrowsItsPool) {
    Random random(3);
    ViewSet set = fullViews(100, 4);
    std::vector<Triangle> triangles;
    for (int i = 0; i < 10; ++i) addSphere(random, triangles, 10, 6);
    const FrameGeometry geometry = geometryOf(std::move(triangles), set);
    const Grid oracle = buildGrid(geometry, set.camera, set.settings);
    ASSERT_GT(oracle.ids.size(), 5'000u);
    for (uint32_t nodes : {1000u, (uint32_t) oracle.ids.size() - 1}) {
        GlOptions options;
        options.poolNodes = nodes;
        GlBackend backend(options);
        EXPECT_TRUE(sameGrid(oracle, build(backend, geometry, set))) << nodes << " nodes";
        EXPECT_TRUE(sameGrid(oracle, build(backend, geometry, set))) << "again";
    }
}

/// A pool of many segments, and one whose segments do not suffice.
TEST(GlBuild, SpreadsItsPoolOverSegments) {
    Random random(4);
    ViewSet set = singleView(200, 150, 8, 60.0f);
    set.settings.bins = 4;
    std::vector<Triangle> triangles;
    for (int i = 0; i < 10; ++i) addRoom(random, triangles);
    addSphere(random, triangles, 30, 20);
    const FrameGeometry geometry = geometryOf(std::move(triangles), set);
    const Grid oracle = buildGrid(geometry, set.camera, set.settings);
    GlOptions options;
    options.poolNodes = 10;
    options.segmentBits = std::bit_width(oracle.ids.size() / 12); // some 7 to 12 segments
    GlBackend backend(options);
    EXPECT_TRUE(sameGrid(oracle, build(backend, geometry, set)));

    options.segmentBits = 7; // 2048 nodes
    GlBackend tooSmall(options);
    try {
        tooSmall.build(geometry, set.camera, set.settings);
        ADD_FAILURE() << "no error";
    } catch (const InputError& error) {
        const std::string text = error.what();
        EXPECT_EQ(text.find('\n'), text.npos);
        const size_t tile = text.find("(--tile "), bins = text.find("--bins ", text.find('('));
        ASSERT_NE(bins, text.npos) << text;
        if (tile != text.npos) set.settings.tile = std::stoi(text.substr(tile + 8));
        set.settings.bins = std::stoi(text.substr(bins + 7));
        EXPECT_GE(set.settings.bins, 1) << text;
        EXPECT_NO_THROW(tooSmall.build(geometry, set.camera, set.settings)) << text;
    }
}

TEST(GlBuild, RefusesHeadsThatFitNoTexture) {
    GridSettings settings;
    settings.viewSize = 2048;
    settings.tile = 1;
    settings.bins = 40; // 4.0 GB
    try {
        sharedBackend().clear(Camera{}, settings);
    } catch (const InputError& error) {
        const std::string text = error.what();
        const size_t tile = text.find("(--tile ");
        ASSERT_NE(tile, text.npos) << text;
        settings.tile = std::stoi(text.substr(tile + 8));
        if (!fullTests()) return; // gigabytes
        EXPECT_NO_THROW(sharedBackend().clear(Camera{}, settings)) << text;
        return;
    }
    GTEST_SKIP() << "this driver has a texture of 2048 x 2048 x 240";
}

TEST(GlBuild, TransformsAsTheDefinition) {
    Random random(5);
    for (int round = 0; round < cases(40, 1000); ++round) {
        Mesh mesh;
        const float size = (float) random.powerOfTwo(-20, 20);
        const glm::vec3 place = uniformPoint(random, round % 3 ? 0.0 : 1e3) * size;
        const int points = random.range(3, 3000);
        for (int i = 0; i < points; ++i)
            mesh.positions.push_back(place + uniformPoint(random, size));
        for (int i = random.range(0, 5000); i > 0; --i)
            mesh.triangles.push_back({(uint32_t) random.below(points),
                                      (uint32_t) random.below(points),
                                      (uint32_t) random.below(points)});
        Camera camera;
        camera.eye = place + uniformPoint(random, size);
        camera.target = camera.eye + uniformPoint(random, size);
        for (ViewMode mode : {ViewMode::full, ViewMode::single}) {
            const FrameGeometry oracle = makeFrameGeometry(mesh, camera, mode);
            sharedBackend().transform(mesh, camera, mode);
            const FrameGeometry geometry = sharedBackend().readGeometry();
            EXPECT_EQ(geometry.frame.scale, oracle.frame.scale);
            ASSERT_EQ(geometry.triangles.size(), oracle.triangles.size());
            for (size_t i = 0; i < oracle.triangles.size(); ++i)
                ASSERT_EQ(hex(geometry.triangles[i]), hex(oracle.triangles[i]));
        }
    }
}

TEST(GlBuild, RefusesWhatDoesNotFitIntoFloats) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {3e38f, 0, 0}, {0, 1, 0}};
    mesh.triangles = {{0, 1, 2}};
    Camera camera;
    camera.eye = {-3e38f, 0, 0};
    EXPECT_THROW(sharedBackend().transform(mesh, camera, ViewMode::full), InputError);
    camera.eye = {0, 0, 0};
    EXPECT_NO_THROW(sharedBackend().transform(mesh, camera, ViewMode::full));
}

TEST(GlBuild, FindsManyTrianglesAtTheEye) {
    const ViewSet set = fullViews(8, 4);
    std::vector<Triangle> triangles(5000, {{1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}});
    for (size_t i = 0; i < triangles.size(); i += 3) triangles[i].a.z = 0.5f;
    const FrameGeometry geometry = geometryOf(std::move(triangles), set);
    const Grid grid = build(sharedBackend(), geometry, set);
    EXPECT_EQ(grid.atEye, trianglesAtEye(geometry));
    EXPECT_EQ(grid.atEye.size(), 3333u);
}

TEST(GlBuild, NoGeometry) {
    const ViewSet set = fullViews(20, 3);
    const FrameGeometry geometry = geometryOf({}, set);
    EXPECT_TRUE(sameGrid(buildGrid(geometry, set.camera, set.settings),
                         build(sharedBackend(), geometry, set)));
    EXPECT_EQ(sharedBackend().listEntries(), 0u);
    EXPECT_NO_THROW(sharedBackend().transform(Mesh{}, set.camera, ViewMode::full));
}

TEST(GlBuild, KeepsWhatIsWritten) {
    Random random(6);
    for (const ViewSet& set : someViews(random)) {
        const FrameGeometry geometry = geometryOf(smallScene(random, set), set);
        const Grid grid = buildGrid(geometry, set.camera, set.settings);
        sharedBackend().writeGrid(grid);
        EXPECT_TRUE(sameGrid(grid, sharedBackend().readGrid())) << describe(set);
    }
}

} // namespace
} // namespace dirt::test
