// A script that shares nothing with dirt but the dumped files checks lists and depth bounds by its
// own arithmetic; and objects to grids that are wrong.

#include "backend_cpu/cpu_backend.h"
#include "core/dump/dump.h"
#include "core/io/load.h"
#include "tests/cli/program.h"

#include <cmath>
#include <filesystem>
#include <functional>
#include <stdexcept>

#include <gtest/gtest.h>

namespace dirt::test {
namespace {

constexpr const char* kPython = "/usr/bin/python3"; // Debian's, which has OpenImageIO's module

const std::string kSource = DIRT_SOURCE_DIR;
const std::string kObj = kSource + "/scenes/generated/cornell.obj";
const std::string kScene = kSource + "/scenes/cornell.scene";

Outcome python(const std::vector<std::string>& arguments) {
    return start(kPython, arguments);
}

Outcome check(const std::string& folder) {
    return python({kSource + "/tests/dump/check_dump.py", folder, kObj});
}

class IndependentCheck : public testing::Test {
protected:
    void SetUp() override {
        if (python({"-c", "import OpenImageIO"}).status != 0)
            GTEST_SKIP() << "there is no " << kPython << " with OpenImageIO's module";
    }
    TemporaryFolder folder_;
    SerialExecutor serial_;
    CpuBackend backend_{serial_};

    /// What dump("16", "8") writes, in backend_.
    void build() {
        const Scene scene = loadScene(kScene).scene;
        GridSettings settings;
        settings.width = 96;
        settings.height = 64;
        settings.bins = 8;
        backend_.build(scene.mesh, scene.camera, settings);
    }

    void dump(const std::string& tile, const std::string& bins) {
        const Outcome run =
            dirt({"dump", kScene, "--size", "96x64", "--tile", tile, "--bins", bins, "--buffers",
                  "triangles,depth,ids", "-o", folder_.path(), "--quiet"});
        ASSERT_EQ(run.status, 0) << run.err;
    }
};

TEST_F(IndependentCheck, AgreesOnCornell) {
    for (const auto& [tile, bins] : {std::pair("16", "8"), {"20", "5"}, {"64", "1"}}) {
        dump(tile, bins);
        const Outcome run = check(folder_.path());
        EXPECT_EQ(run.status, 0) << run.err;
        EXPECT_NE(run.out.find("of 36 triangles in 6 views"), std::string::npos) << run.out;
    }
}

TEST_F(IndependentCheck, ObjectsToWrongGrids) {
    dump("16", "8");
    ASSERT_EQ(check(folder_.path()).status, 0);

    build();
    const auto objection = [&](const std::function<void(Grid&)>& spoil) {
        Grid grid = backend_.grid();
        spoil(grid);
        Dump dump(folder_.path(), 96, 64, {});
        dump.depth(grid);
        dump.ids(grid, backend_.geometry());
        const Outcome run = check(folder_.path());
        EXPECT_EQ(run.status, 1) << run.out;
        return run.err;
    };
    const auto filled = [](Grid& grid, int level) -> DepthBounds& {
        for (DepthPyramid& pyramid : grid.pyramids)
            for (DepthBounds& bounds : pyramid.levels[level].bounds)
                if (!bounds.empty()) return bounds;
        throw std::logic_error("nothing there");
    };

    const std::string where = "check_dump: view";
    EXPECT_EQ(objection([](Grid& grid) { grid.ids.front() = 35; }).substr(0, where.size()), where);
    EXPECT_EQ(objection([](Grid& grid) { // the last entry of a list moves to the next
                  size_t cell = 0;
                  while (grid.heads[cell + 1] == grid.heads[cell]) ++cell;
                  --grid.heads[cell + 1];
              })
                  .substr(0, where.size()),
              where);
    EXPECT_EQ(
        objection([&](Grid& grid) { filled(grid, 0).far *= 1.000001f; }).substr(0, where.size()),
        where);
    const std::string text = objection([&](Grid& grid) { filled(grid, 1).near *= 0.999999f; });
    EXPECT_NE(text.find("near"), std::string::npos) << text;
}

/// The example that compares dumps names the one list entry, and the one value, that are not alike.
TEST_F(IndependentCheck, ComparedDumpsNameWhatDiffers) {
    dump("16", "8");
    const std::filesystem::path a = folder_.path() / "a", b = folder_.path() / "b";
    for (const auto& copy : {a, b}) {
        std::filesystem::create_directory(copy);
        for (const char* file : {"manifest.json", "triangles.exr", "depth.exr", "ids.exr"})
            std::filesystem::copy(folder_.path() / file, copy / file);
    }
    const auto compare = [&] {
        return python({kSource + "/examples/dump/compare_dumps.py", a, b});
    };
    const Outcome same = compare();
    EXPECT_EQ(same.status, 0) << same.out << same.err;
    EXPECT_EQ(same.out, "0 differences\n");

    build();
    Grid grid = backend_.grid();
    size_t cell = 0; // the first with a list, which loses its only or last entry
    while (grid.heads[cell + 1] == grid.heads[cell]) ++cell;
    const size_t tile = cell / 8, bin = cell % 8, view = 5;
    ASSERT_GE(tile, grid.firstTile[view]) << "the room is seen ahead alone";
    const uint32_t lost = grid.ids[grid.heads[cell + 1] - 1];
    grid.ids.erase(grid.ids.begin() + grid.heads[cell + 1] - 1);
    for (size_t i = cell + 1; i < grid.heads.size(); ++i) --grid.heads[i];
    const size_t inView = tile - grid.firstTile[view];
    const std::string place = std::to_string(inView % (size_t) grid.views[view].columns) + "," +
                              std::to_string(inView / (size_t) grid.views[view].columns);
    DepthBounds& bounds = grid.pyramids[view].levels[0].bounds[inView];
    bounds.far = std::nextafter(bounds.far, 2.0f);
    Dump spoilt(b, 96, 64, {});
    spoilt.depth(grid);
    spoilt.ids(grid, backend_.geometry());
    const Outcome run = compare();
    EXPECT_EQ(run.status, 1);
    for (const std::string& said :
         {"entries only in " + a.string() + "; " + place + ": ", "bin " + std::to_string(bin) + ",",
          "id " + std::to_string(lost) + ",", std::string("far.Z: 1 of 16 differ; ") + place + ": ",
          std::string("\n2 differences\n")})
        EXPECT_NE(run.out.find(said), run.out.npos) << said << "\n" << run.out;
}

} // namespace
} // namespace dirt::test
