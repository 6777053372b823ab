// The passes that rasterize, over the real scenes: Fetch finds every record exactly once and gives
// the bits of Fetch by primitive id; DirectVisibility gives those of traced primary rays.

#include "backend_cpu/cpu_backend.h"
#include "backend_cpu/thread_pool.h"
#include "core/frame/auto_camera.h"
#include "core/frame/renderer.h"
#include "core/io/load.h"
#include "tests/io/test_scenes.h"
#include "tests/support/random.h"

#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace dirt {
namespace {

namespace fs = std::filesystem;

/// Every OBJ file of the folder of real scenes but the odd ones that assimp collects.
std::vector<std::string> files() {
    std::vector<std::string> found;
    std::error_code absent;
    for (const auto& entry : fs::recursive_directory_iterator(scenesFolder(), absent))
        if (entry.path().extension() == ".obj" &&
            entry.path().string().find("assimp") == std::string::npos)
            found.push_back(fs::relative(entry.path(), scenesFolder()).string());
    std::sort(found.begin(), found.end());
    return found;
}

size_t countDifferent(const std::vector<SurfacePoint>& a, const std::vector<SurfacePoint>& b) {
    EXPECT_EQ(a.size(), b.size());
    size_t different = 0;
    for (size_t i = 0; i < a.size(); ++i) different += std::memcmp(&a[i], &b[i], sizeof a[i]) != 0;
    return different;
}

/// Checks each path event's raster fetch; gives G[1].
std::vector<SurfacePoint> checkFetches(const Scene& scene, const RenderSettings& settings,
                                       CpuBackend& backend, Executor& executor) {
    std::vector<SurfacePoint> first;
    RenderHooks hooks;
    hooks.observe = [&](uint32_t, int event) {
        PathBuffers paths = backend.readPaths();
        if (event == 0) first = paths.next;
        if (event == 0 && settings.primary == Primary::raster) return;
        const std::vector<SurfacePoint> raster = paths.next;
        size_t wrong = 0;
        for (Hit& hit : paths.hits) wrong += hit.fetches != (hit.found() ? 1u : 0u);
        EXPECT_EQ(wrong, 0u) << "records not found exactly once, event " << event;
        const FrameGeometry geometry = backend.readGeometry();
        passFetch(FrameContext(scene, geometry, settings, requirementsOf(scene, settings, true)),
                  executor, paths);
        EXPECT_EQ(countDifferent(raster, paths.next), 0u) << "event " << event;
    };
    Renderer(scene, settings, backend).render(hooks);
    return first;
}

TEST(RasterPassesOnRealScenes, EqualWhatTheyStandInFor) {
    const std::vector<std::string> all = files();
    if (all.empty()) GTEST_SKIP() << "no OBJ files in " << scenesFolder();
    ThreadPool pool;
    for (const std::string& file : all) {
        SCOPED_TRACE(file);
        Scene scene = loadScene(scenesFolder() / file).scene;
        CpuBackend backend(pool);
        const Standpoint standpoint = chooseStandpoint(scene.mesh, backend, {});
        scene.camera = standpoint.camera;
        RenderSettings settings;
        settings.samples = 1;
        settings.bounces = 3;
        settings.grid.width = test::cases(128, 1024);
        settings.grid.height = test::cases(64, 512);
        for (const ViewMode mode : {ViewMode::full, ViewMode::single})
            for (const int tile : test::fullTests() ? std::vector{1, 4, 16, 64} : std::vector{4}) {
                settings.grid.mode = mode;
                settings.grid.tile = tile;
                settings.primary = Primary::traced;
                const auto traced = checkFetches(scene, settings, backend, pool);
                settings.primary = Primary::raster;
                settings.bounces = 1;
                const auto raster = checkFetches(scene, settings, backend, pool);
                settings.bounces = 3;
                EXPECT_EQ(countDifferent(traced, raster), 0u);
            }
    }
}

} // namespace
} // namespace dirt
