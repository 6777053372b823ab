// What the viewer without its window does beyond a walk: paths and lists are told, scenes play and
// change, and memory stays.

#include "app/viewer/view_model.h"

#include "core/frame/renderer.h"
#include "tests/support/random.h"
#include "tests/viewer/view_model_fixture.h"

#include <array>
#include <chrono>
#include <fstream>
#include <memory>
#include <string>
#include <thread>

#include <unistd.h>

#include <gtest/gtest.h>

namespace dirt {
namespace {

class ViewQuestions : public test::ViewModelTest {};

TEST_F(ViewQuestions, APathIsToldAndDrawnRayByRay) {
    ViewModel model(options());
    ASSERT_TRUE(rest(model));
    for (const char* kind : {"image", "near", "overview", "normal"}) {
        model.change([&](ViewState& s) {
            s.shown = previewKind(kind);
            showRay(s, 0.5, 0.5);
        });
        const auto shown = rest(model);
        ASSERT_TRUE(shown) << kind;
        ASSERT_GT(shown->path.size(), 2u) << kind; // all, that from the eye, and to the light
        EXPECT_NE(shown->path[0].text.find("pixel (24, 16)"), std::string::npos);
        EXPECT_NE(shown->path[1].text.find("primary ray"), std::string::npos);
        EXPECT_NE(shown->path[2].text.find("shadow ray"), std::string::npos);
        for (const PathStep& step : shown->path) EXPECT_GT(step.marks.size(), 0u) << kind;
    }
    model.change([](ViewState& s) { s.ray.reset(); });
    EXPECT_TRUE(rest(model)->path.empty());
}

TEST_F(ViewQuestions, ATilesListsAreTold) {
    ViewModel model(options());
    ASSERT_TRUE(rest(model));
    model.change([](ViewState& s) { s.shown = previewKind("entries"); });
    const auto all = rest(model);
    ASSERT_TRUE(all);
    EXPECT_EQ(all->told, "");
    // One that lists something.
    std::array<int, 3> tile{};
    double entries = 0;
    for (const PictureValues& part : all->values)
        for (int y = 0; y < part.rows(); ++y)
            for (int x = 0; x < part.columns(); ++x) {
                const double here = part.numbers[(size_t) (y * part.columns() + x)];
                if (here > entries) entries = here, tile = {part.view, x, y};
            }
    ASSERT_GT(entries, 0);
    model.change([&](ViewState& s) { s.tile = tile; });
    const auto told = rest(model);
    ASSERT_TRUE(told);
    EXPECT_EQ(told->marks.size(), 1u);
    EXPECT_NE(told->told.find("entries, 0 wrong"), std::string::npos) << told->told;
    EXPECT_NE(told->told.find("of view " + std::to_string(tile[0])), std::string::npos);
    // In a picture of other tiles it may not be there.
    model.change([&](ViewState& s) { s.tile = {9, 0, 0}; });
    EXPECT_EQ(rest(model)->told, "");
}

TEST_F(ViewQuestions, AnAnimatedScenePlaysAndPauses) {
    CommonOptions common = options();
    common.scene = DIRT_SOURCE_DIR "/scenes/turning.scene";
    ViewModel model(common);
    ASSERT_TRUE(comes([&] { return model.picture() && model.picture()->frame > 2; }));
    EXPECT_TRUE(model.state().playing);
    model.change([](ViewState& s) { s.playing = false; });
    const auto paused = rest(model);
    ASSERT_TRUE(paused);
    EXPECT_EQ(paused->frame, model.state().frame);
    // What render gives for that frame.
    common.frame = paused->frame;
    const auto executor = makeExecutor(common);
    const Input input = openInput(common, *executor);
    const auto backend = makeBackend(common, *executor);
    EXPECT_EQ(paused->image.pixels,
              Renderer(input.scene, input.settings, *backend).render().image.pixels);
    // Another one by hand, and on from there, over the end.
    const int last = model.facts().lastFrame;
    ASSERT_GT(last, 0);
    model.change([&](ViewState& s) { s.frame = last; });
    EXPECT_EQ(rest(model)->frame, last);
    model.change([](ViewState& s) { s.playing = true; });
    EXPECT_TRUE(comes([&] { return model.picture()->frame < last; }));
    // With --frame it stands.
    ViewModel standing(common);
    ASSERT_TRUE(rest(standing));
    EXPECT_EQ(rest(standing)->frame, *common.frame);
}

TEST_F(ViewQuestions, AnotherSceneIsOpenedAndABadOneIsNot) {
    CommonOptions common = options();
    common.eye = glm::dvec3(0, 5, 5); // of the first alone
    common.target = glm::dvec3(0, 0, 0);
    ViewModel model(common);
    const auto first = rest(model);
    ASSERT_TRUE(first);
    model.change([](ViewState& s) { s.settings.grid.width = 40, s.settings.grid.height = 20; });
    const std::string other = folder_.write("other.obj", "v 0 0 0\nv 9 0 0\nv 0 9 0\nf 1 2 3\n");
    model.open(other);
    ASSERT_TRUE(comes([&] { return model.facts().name == "other"; }));
    const auto second = rest(model);
    ASSERT_TRUE(second);
    EXPECT_EQ(second->width, 40);
    EXPECT_EQ(model.facts().triangles, 1u);
    EXPECT_NE(model.state().camera.eye, glm::vec3(0, 5, 5));
    model.open((folder_.path() / "none.obj").string());
    ASSERT_TRUE(comes([&] { return !model.problem().empty(); }));
    EXPECT_EQ(model.facts().name, "other");
    EXPECT_EQ(rest(model)->image.pixels, second->image.pixels);
    // What is read again is that which is there.
    model.reload();
    ASSERT_TRUE(rest(model));
    EXPECT_EQ(model.problem(), "");
    EXPECT_EQ(model.facts().file, other);
}

TEST_F(ViewQuestions, ThreadsAndToneMappingChange) {
    ViewModel model(options());
    const auto before = rest(model);
    ASSERT_TRUE(before);
    model.change([](ViewState& s) { s.threads = 1; });
    const auto one = rest(model);
    ASSERT_TRUE(one);
    EXPECT_EQ(one->image.pixels, before->image.pixels);
    EXPECT_NE(one->device, before->device);
    model.change([](ViewState& s) { s.toneMapping.key += 1.0f; });
    const auto brighter = rest(model);
    ASSERT_TRUE(brighter);
    EXPECT_EQ(brighter->image.pixels, before->image.pixels);
    EXPECT_NE(brighter->picture.rgb, before->picture.rgb);
}

size_t residentBytes() {
    std::ifstream file("/proc/self/statm");
    size_t all = 0, resident = 0;
    file >> all >> resident;
    return resident * (size_t) sysconf(_SC_PAGESIZE);
}

TEST_F(ViewQuestions, MemoryDoesNotGrowFromFrameToFrame) {
    CommonOptions common = options();
    common.size = ImageSize{24, 16};
    ViewModel model(common);
    ASSERT_TRUE(rest(model));
    const auto walk = [&](int frames) {
        for (int i = 0; i < frames; ++i) {
            model.change([&](ViewState& s) { s.camera.eye.x += i % 2 ? 0.1f : -0.1f; }, true);
            const uint64_t change = model.changes();
            while (model.picture()->change != change) std::this_thread::yield();
        }
    };
    const int frames = test::fullTests() ? 5000 : 500;
    walk(frames / 2);
    const size_t before = residentBytes();
    walk(frames / 2);
    EXPECT_LT((double) residentBytes(), (double) before + 2e6);
}

} // namespace
} // namespace dirt
