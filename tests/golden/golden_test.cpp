// The scenes beside this file, which between them use what the transport knows, against pictures of
// them that somebody has looked at. DIRT_PROMOTE=1 makes today's pictures the expected ones.

#include "backend_cpu/cpu_backend.h"
#include "backend_cpu/thread_pool.h"
#include "core/frame/renderer.h"
#include "core/io/image.h"
#include "core/io/load.h"
#include "core/path/tone_mapping.h"
#include "tests/support/golden_scenes.h"
#include "tests/support/temporary_folder.h"

#include <cstdlib>

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

    const std::string expected = test::goldenFolder() / "images" / (GetParam() + ".png");
    if (std::getenv("DIRT_PROMOTE")) writePng(expected, image.width, image.height, bytes, {});
    const test::TemporaryFolder folder;
    writePng(folder / "now.png", image.width, image.height, bytes, {});
    const Image before = readImage(expected), now = readImage(folder / "now.png");
    ASSERT_EQ(before.pixels.size(), now.pixels.size());
    size_t different = 0;
    for (size_t i = 0; i < now.pixels.size(); ++i) different += now.pixels[i] != before.pixels[i];
    EXPECT_EQ(different, 0u) << "pixels; to look at what it is now, and to keep it:\n"
                             << "  dirt render tests/golden/scenes/" << GetParam() << ".scene\n"
                             << "  DIRT_PROMOTE=1 build/release/tests/golden_golden_test";
}

INSTANTIATE_TEST_SUITE_P(Scenes, Golden, testing::ValuesIn(test::goldenScenes()),
                         [](const auto& info) { return info.param; });

} // namespace
} // namespace dirt
