#include "core/cost/footprint.h"

#include "backend_cpu/cpu_backend.h"
#include "backend_cpu/thread_pool.h"
#include "core/io/load.h"
#include "tests/support/mesh_of.h"
#include "tests/support/small_scenes.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

namespace dirt {
namespace {

using test::meshOf;

Camera lookingAround() {
    Camera camera;
    camera.eye = {0, 0, 0};
    camera.target = {0, 0, -1};
    camera.up = {0, 1, 0};
    camera.verticalFov = 60;
    return camera;
}

/// Entries that the CPU backend's build lists.
double listed(const Mesh& mesh, const Camera& camera, const GridSettings& grid, Executor& pool) {
    CpuBackend backend(pool);
    backend.build(mesh, camera, grid);
    return (double) backend.listEntries();
}

/// Holds the forecast to within a quarter of what is listed. (At tile 8 it says up to a third too
/// much: the larger triangles' depths in each tile are those of their bounding boxes.)
void expectNear(const Mesh& mesh, const Camera& camera, const char* what) {
    ThreadPool pool(2);
    for (const ViewMode mode : {ViewMode::full, ViewMode::single}) {
        GridSettings grid;
        grid.mode = mode;
        const Footprint footprint(mesh, camera, grid, pool);
        for (const int tile : {16, 32, 64})
            for (const int bins : {1, 4, 16}) {
                grid.tile = tile;
                grid.bins = bins;
                const double built = listed(mesh, camera, grid, pool);
                EXPECT_NEAR(footprint.listEntries(grid) / built, 1.0, 0.25)
                    << what << (mode == ViewMode::full ? ", full" : ", single") << ", tile " << tile
                    << ", " << bins << " bins: " << built << " entries";
            }
    }
}

TEST(Footprint, CountsTheTilesOfAWallThatFacesTheEye) {
    // One triangle over slopes [-1/2, 1/2] x [-1/2, 1/2] of the view along -z, at one depth.
    const Mesh mesh = meshOf({{{-0.5f, -0.5f, -1.0f}, {0.5f, -0.5f, -1.0f}, {-0.5f, 0.5f, -1.0f}}});
    GridSettings grid;
    grid.height = 512;
    grid.precision = Precision::fast; // no guard band
    SerialExecutor serial;
    const Footprint footprint(mesh, lookingAround(), grid, serial);
    EXPECT_EQ(footprint.polygons(), 1.0);
    grid.bins = 1;
    grid.tile = 32; // slopes of 1/8: half of 8 x 8 tiles, 8 + 8 for its sides, and one
    EXPECT_NEAR(footprint.listEntries(grid), 32 + 16 + 1, 1e-9);
    // Its depth is rounded both ways: alone in its tiles it lies in all of their bins.
    grid.bins = 16;
    EXPECT_GT(footprint.listEntries(grid), 8 * (32 + 16 + 1));
}

TEST(Footprint, IsTheSameForAnyNumberOfThreads) {
    test::Random random(7);
    std::vector<Triangle> triangles;
    test::addSoup(random, triangles, 20000);
    const Mesh mesh = meshOf(triangles);
    GridSettings grid;
    SerialExecutor serial;
    ThreadPool pool(3);
    EXPECT_EQ(Footprint(mesh, lookingAround(), grid, serial).listEntries(grid),
              Footprint(mesh, lookingAround(), grid, pool).listEntries(grid));
}

TEST(Footprint, ForecastsTheListsOfTriangleSoup) {
    test::Random random(1);
    std::vector<Triangle> triangles;
    test::addSoup(random, triangles, 4000);
    expectNear(meshOf(triangles), lookingAround(), "soup");
}

TEST(Footprint, ForecastsTheListsOfARoomOfSpheres) {
    test::Random random(2);
    std::vector<Triangle> triangles;
    for (int i = 0; i < 12; ++i) test::addSphere(random, triangles, 40, 20);
    test::addRoom(random, triangles);
    expectNear(meshOf(triangles), lookingAround(), "room");
}

TEST(Footprint, MeasuresEachNthOfVeryManyTriangles) {
    test::Random random(3);
    std::vector<Triangle> triangles;
    for (int i = 0; i < 50; ++i) test::addSphere(random, triangles, 120, 60);
    ASSERT_GT(triangles.size(), 600000u);
    ThreadPool pool(2);
    const Mesh mesh = meshOf(triangles);
    GridSettings grid;
    const Footprint footprint(mesh, lookingAround(), grid, pool);
    EXPECT_NEAR(footprint.listEntries(grid) / listed(mesh, lookingAround(), grid, pool), 1, 0.05);
}

TEST(Footprint, ForecastsTheListsOfRealScenes) {
    const char* folder = std::getenv("DIRT_SCENES");
    const std::filesystem::path scenes = folder ? folder : DIRT_SOURCE_DIR "/../shared/scenes";
    struct Real {
        const char* file;
        glm::vec3 eye, target;
    };
    for (const Real& real : {Real{"cornell-boxes/CornellBox-Glossy.obj", {0, 1, 3}, {0, 1, 0}},
                             Real{"crytek-sponza/sponza.obj", {-1100, 250, -50}, {1000, 300, 0}},
                             Real{"conference/conference.obj", {900, 400, 500}, {0, 150, -300}}}) {
        if (!std::filesystem::exists(scenes / real.file)) GTEST_SKIP() << "no " << real.file;
        Camera camera = lookingAround();
        camera.eye = real.eye;
        camera.target = real.target;
        expectNear(loadScene(scenes / real.file).scene.mesh, camera, real.file);
    }
}

} // namespace
} // namespace dirt
