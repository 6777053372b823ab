#include "core/cost/cost_model.h"

#include "tests/support/mesh_of.h"
#include "tests/support/small_scenes.h"

#include <gtest/gtest.h>

namespace dirt {
namespace {

/// Spheres in a room, seen from inside.
Footprint roomOfSpheres() {
    test::Random random(4);
    std::vector<Triangle> triangles;
    for (int i = 0; i < 20; ++i) test::addSphere(random, triangles, 60, 30);
    test::addRoom(random, triangles);
    Camera camera;
    camera.target = {0, 0, -1};
    camera.eye = {0, 0, 0};
    SerialExecutor serial;
    return {test::meshOf(triangles), camera, GridSettings(), serial};
}

double frameCost(const Footprint& footprint, const RenderSettings& settings,
                 const GridSettings& grid) {
    const GridCost cost = gridCost(footprint, grid);
    return cost.build + cost.ray * settings.grid.width * settings.grid.height * settings.samples *
                            (settings.bounces - 1);
}

TEST(CostModel, ChoosesWhatCostsAFrameLeast) {
    const Footprint footprint = roomOfSpheres();
    for (const int samples : {1, 64}) {
        RenderSettings settings;
        settings.samples = samples;
        const GridSettings chosen = chooseGrid(footprint, settings, true, true);
        for (const int tile : {8, 16, 32, 64})
            for (const int bins : {1, 2, 4, 8, 16, 32}) {
                GridSettings grid = settings.grid;
                grid.tile = tile;
                grid.bins = bins;
                EXPECT_LE(frameCost(footprint, settings, chosen),
                          frameCost(footprint, settings, grid))
                    << "tile " << tile << ", " << bins << " bins";
            }
    }
}

TEST(CostModel, KeepsWhatIsGiven) {
    const Footprint footprint = roomOfSpheres();
    RenderSettings settings;
    settings.grid.tile = 5;
    settings.grid.bins = 7;
    settings.grid.viewSize = 100;
    EXPECT_EQ(chooseGrid(footprint, settings, false, false), settings.grid);
    EXPECT_EQ(chooseGrid(footprint, settings, false, true).tile, 5);
    EXPECT_EQ(chooseGrid(footprint, settings, true, false).bins, 7);
    EXPECT_EQ(chooseGrid(footprint, settings, true, true).viewSize, 100);
}

TEST(CostModel, PaysForARaysGridInTheBuild) {
    const Footprint footprint = roomOfSpheres();
    RenderSettings one, many;
    one.samples = 1;
    many.samples = 1024;
    const GridCost quick = gridCost(footprint, chooseGrid(footprint, one, true, true));
    const GridCost fine = gridCost(footprint, chooseGrid(footprint, many, true, true));
    EXPECT_LE(quick.build, fine.build);
    EXPECT_GE(quick.ray, fine.ray);
    EXPECT_GT(quick.ray, 0.0);
}

} // namespace
} // namespace dirt
