// The scenes beside this file, which between them use what the transport knows, against pictures of
// them that somebody has looked at. DIRT_PROMOTE=1 makes today's pictures the expected ones.

#include "backend_cpu/cpu_backend.h"
#include "backend_cpu/thread_pool.h"
#include "core/frame/renderer.h"
#include "core/io/load.h"
#include "core/path/tone_mapping.h"
#include "tests/support/golden_picture.h"

#include <gtest/gtest.h>

namespace dirt {
namespace {

class Golden : public testing::TestWithParam<std::string> {};

TEST_P(Golden, LooksAsItDid) {
    const LoadedScene loaded = loadScene(test::goldenFolder() / "scenes" / (GetParam() + ".scene"));
    for (const Warning& warning : loaded.warnings) // one has a material that is meant to be hidden
        EXPECT_EQ(warning.kind, WarningKind::unseenMaterial) << warning.text;
    ThreadPool pool;
    CpuBackend backend(pool);
    const RenderSettings settings = test::goldenSettings(loaded, 16);
    const Image image = Renderer(loaded.scene, settings, backend).render().image;
    const auto bytes = DisplayEncoding(loaded.scene.toneMapping).bytes(image.pixels);

    test::expectGolden(GetParam(), image.width, image.height, bytes);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Golden, testing::ValuesIn(test::goldenScenes()),
                         [](const auto& info) { return info.param; });

} // namespace
} // namespace dirt
