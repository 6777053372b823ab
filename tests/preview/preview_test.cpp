// Pictures of buffers show what the buffers hold, the same for every backend.

#include "core/preview/preview.h"

#include "backend_cpu/cpu_backend.h"
#include "backend_cpu/thread_pool.h"
#include "core/frame/renderer.h"
#include "core/path/tone_mapping.h"
#include "tests/io/input_error.h"
#include "tests/support/golden_scenes.h"

#ifdef DIRT_HAVE_EMBREE
#include "backend_embree/embree_backend.h"
#endif

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace dirt {
namespace {

class Preview : public testing::Test {
protected:
    Preview()
        : loaded_(loadScene(test::goldenFolder() / "scenes" / "maps.scene")),
          settings_(test::goldenSettings(loaded_, 2)) {
        settings_.grid.width = 48;
        settings_.grid.height = 24;
        settings_.grid.tile = 4;
        settings_.primary = Primary::traced;
    }

    static const PreviewKind& kind(const std::string& name) {
        const auto kinds = previewKinds();
        return *std::find_if(kinds.begin(), kinds.end(),
                             [&](const PreviewKind& k) { return name == k.name; });
    }
    PreviewPicture draw(Backend& backend, const std::string& name, PreviewRequest request = {}) {
        request.kind = &kind(name);
        return drawPreview(loaded_.scene, settings_, backend, request);
    }

    LoadedScene loaded_;
    RenderSettings settings_;
    ThreadPool pool_{2};
    CpuBackend cpu_{pool_};
};

size_t coloursIn(const PreviewPicture& picture) {
    std::set<std::array<uint8_t, 3>> colours;
    for (size_t i = 0; i + 2 < picture.rgb.size(); i += 3)
        colours.insert({picture.rgb[i], picture.rgb[i + 1], picture.rgb[i + 2]});
    return colours.size();
}

TEST_F(Preview, DrawsEveryKind) {
    for (const PreviewKind& kind : previewKinds()) {
        SCOPED_TRACE(kind.name);
        const std::string name = kind.name;
        settings_.visibility =
            name == "shadowmap" ? LightVisibility::shadowMap : LightVisibility::traced;
        PreviewRequest request;
        request.event = kind.perEvent ? 1 : 0; // from the eye all rays have one tile
        const PreviewPicture picture = draw(cpu_, name, request);
        ASSERT_EQ(picture.rgb.size(), 3 * (size_t) picture.width * (size_t) picture.height);
        EXPECT_FALSE(picture.scale.empty());
        // Nothing shines in this scene, and all of its surfaces reflect.
        EXPECT_GE(coloursIn(picture), name == "emission" || name == "mask" ? 1u : 2u);
        if (!kind.perView && name != "shadowmap") EXPECT_EQ(picture.width, 48);
    }
}

TEST_F(Preview, TheImageIsThatOfRender) {
    const Image image = Renderer(loaded_.scene, settings_, cpu_).render().image;
    EXPECT_EQ(draw(cpu_, "image").rgb,
              DisplayEncoding(loaded_.scene.toneMapping).bytes(image.pixels));
}

/// The scale's end is the fullest tile, which has the brightest colour; empty ones are black.
TEST_F(Preview, CountsEntries) {
    const PreviewPicture picture = draw(cpu_, "entries");
    const Grid grid = cpu_.readGrid();
    size_t most = 0, emptyTiles = 0;
    int fullest = 0;
    for (int tile = 0; tile < grid.views[0].tiles(); ++tile) {
        size_t entries = 0;
        for (int bin = 0; bin < grid.settings.bins; ++bin)
            entries += grid.list(0, tile, bin).size();
        emptyTiles += entries == 0;
        if (entries > most) {
            most = entries;
            fullest = tile;
        }
    }
    ASSERT_EQ(grid.views.size(), 6u);
    EXPECT_EQ(picture.width, 3 * grid.views[0].columns);
    EXPECT_EQ(picture.height, 2 * grid.views[0].rows);
    const int column = fullest % grid.views[0].columns, row = fullest / grid.views[0].columns;
    const auto sum = [&](int x, int y) {
        const size_t at = 3 * (size_t) (y * picture.width + x);
        return picture.rgb[at] + picture.rgb[at + 1] + picture.rgb[at + 2];
    };
    size_t black = 0;
    int brightest = 0;
    for (int y = 0; y < grid.views[0].rows; ++y)
        for (int x = 0; x < grid.views[0].columns; ++x) {
            black += sum(x, y) == 0;
            brightest = std::max(brightest, sum(x, y));
        }
    EXPECT_EQ(black, emptyTiles);
    EXPECT_EQ(sum(column, row), brightest);
}

TEST_F(Preview, AsksForWhatThereIs) {
    PreviewRequest request;
    request.level = 13;
    EXPECT_NE(inputError([&] { draw(cpu_, "near", request); }).find("--level 13"),
              std::string::npos);
    EXPECT_NE(inputError([&] { draw(cpu_, "shadowmap"); }).find("has none"), std::string::npos);
    request.event = 40;
    EXPECT_NE(inputError([&] { draw(cpu_, "hits", request); }).find("path events"),
              std::string::npos);
}

#ifdef DIRT_HAVE_EMBREE
TEST_F(Preview, IsTheSameWithEmbree) {
    EmbreeBackend embree(pool_);
    for (const char* name : {"image", "hits", "distance", "visibility", "position", "normal",
                             "geometric-normal", "diffuse", "roughness", "reflectance", "metallic"})
        EXPECT_EQ(draw(cpu_, name).rgb, draw(embree, name).rgb) << name;
    for (const char* name : {"near", "entries", "tests"})
        EXPECT_NE(inputError([&] { draw(embree, name); }).find("no grid"), std::string::npos);
}
#endif

} // namespace
} // namespace dirt
