// A script that shares nothing with dirt but the dumped files checks lists and depth bounds by its
// own arithmetic; and objects to grids that are wrong.

#include "backend_cpu/cpu_backend.h"
#include "core/dump/dump.h"
#include "core/io/load.h"
#include "tests/cli/program.h"

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

    SerialExecutor serial;
    CpuBackend backend(serial);
    const Scene scene = loadScene(kScene).scene;
    GridSettings settings;
    settings.width = 96;
    settings.height = 64;
    settings.bins = 8;
    backend.build(scene.mesh, scene.camera, settings);
    const auto objection = [&](const std::function<void(Grid&)>& spoil) {
        Grid grid = backend.grid();
        spoil(grid);
        Dump dump(folder_.path(), 96, 64, {});
        dump.depth(grid);
        dump.ids(grid, backend.geometry());
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

} // namespace
} // namespace dirt::test
