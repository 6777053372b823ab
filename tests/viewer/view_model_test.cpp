// The viewer without its window: what it shows at rest, while things move, and when something
// fails.

#include "app/viewer/view_model.h"

#include "core/frame/renderer.h"
#include "tests/support/random.h"
#include "tests/support/temporary_folder.h"

#include <array>
#include <chrono>
#include <fstream>
#include <functional>
#include <memory>
#include <string>
#include <thread>

#include <unistd.h>

#include <gtest/gtest.h>

namespace dirt {
namespace {

constexpr const char* kFloorAndBox = "v -2 0 -4\nv 2 0 -4\nv 2 0 1\nv -2 0 1\n"
                                     "v -1 0 -3\nv 1 0 -3\nv 1 1.5 -3\nv -1 1.5 -3\n"
                                     "f 1 4 3 2\nf 5 6 7 8\n";

class ViewModelTest : public testing::Test {
protected:
    CommonOptions options(const std::string& text = kFloorAndBox) {
        CommonOptions options;
        options.scene = folder_.write("box.obj", text);
        options.size = ImageSize{48, 32};
        options.samples = 4;
        options.bounces = 2;
        options.threads = 2;
        options.quiet = options.noCache = true;
        return options;
    }

    /// Whether it comes true within a time that no machine needs.
    static bool comes(const std::function<bool()>& what) {
        for (int i = 0; i < 6000; ++i) {
            if (what()) return true;
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
        return false;
    }

    /// The picture of the last change with all its samples; null if it does not come.
    static std::shared_ptr<const ViewPicture> rest(const ViewModel& model) {
        std::shared_ptr<const ViewPicture> picture;
        comes([&] {
            picture = model.picture();
            return picture && picture->done && picture->change == model.changes();
        });
        return picture;
    }

    test::TemporaryFolder folder_;
};

TEST_F(ViewModelTest, AtRestIsWhatRenderGives) {
    const CommonOptions common = options();
    const auto executor = makeExecutor(common);
    const Input input = openInput(common, *executor);
    const auto backend = makeBackend(common, *executor);
    const Image expected = Renderer(input.scene, input.settings, *backend).render().image;

    ViewModel model(common);
    const auto picture = rest(model);
    ASSERT_TRUE(picture);
    EXPECT_EQ(picture->samples, 4);
    EXPECT_EQ(picture->image.pixels, expected.pixels);
    EXPECT_EQ(picture->picture.width, 48);
    EXPECT_GT(picture->error, 0.0);
    EXPECT_EQ(model.problem(), "");
    // And again after a movement to and fro.
    const ViewState before = model.state();
    model.change([](ViewState& s) { s.camera.eye.x += 0.5f; }, true);
    model.change([&](ViewState& s) { s = before; }, true);
    const auto later = rest(model);
    ASSERT_TRUE(later);
    EXPECT_EQ(later->image.pixels, expected.pixels);
}

TEST_F(ViewModelTest, ChangesAreDrawnAndTellWhichTheyAre) {
    ViewModel model(options());
    const auto first = rest(model);
    ASSERT_TRUE(first);
    model.change([](ViewState& s) { s.settings.grid.width = 33, s.settings.grid.tile = 1; });
    const auto second = rest(model);
    ASSERT_TRUE(second);
    EXPECT_EQ(second->change, first->change + 1);
    EXPECT_EQ(second->image.width, 33);
    model.change([](ViewState& s) { s.shown = previewKind("entries"); });
    const auto third = rest(model);
    ASSERT_TRUE(third);
    EXPECT_NE(third->scale.find("entries"), std::string::npos);
    EXPECT_TRUE(third->image.pixels.empty());
    model.change([](ViewState& s) { s.shown = previewKind("image"), s.progressive = false; });
    EXPECT_EQ(rest(model)->samples, 1);
}

TEST_F(ViewModelTest, WhileTheCameraMovesPicturesAreCoarse) {
    CommonOptions common = options();
    common.size = ImageSize{640, 480};
    ViewModel model(common);
    ASSERT_TRUE(comes([&] { return model.picture() != nullptr; }));
    model.change([](ViewState& s) { s.camera.eye.y += 0.1f; }, true);
    const uint64_t change = model.changes();
    std::shared_ptr<const ViewPicture> coarse;
    ASSERT_TRUE(comes([&] { return (coarse = model.picture())->change == change; }));
    EXPECT_LT(coarse->width, 640);
    EXPECT_FALSE(coarse->done);
    EXPECT_EQ(coarse->samples, 1);
    const auto fine = rest(model);
    ASSERT_TRUE(fine);
    EXPECT_EQ(fine->width, 640);
    EXPECT_EQ(fine->change, change);
}

TEST_F(ViewModelTest, WhatCannotBeLoadedIsSaidAndMayComeLater) {
    CommonOptions common = options();
    common.scene = (folder_.path() / "none.obj").string();
    ViewModel model(common);
    ASSERT_TRUE(comes([&] { return !model.problem().empty(); }));
    EXPECT_NE(model.problem().find("none.obj"), std::string::npos);
    EXPECT_FALSE(model.loaded());
    model.change([](ViewState& s) { s.settings.bounces = 7; }); // there is nothing to change
    folder_.write("none.obj", kFloorAndBox);
    model.reload();
    ASSERT_TRUE(rest(model));
    EXPECT_EQ(model.problem(), "");
    EXPECT_EQ(model.state().settings.bounces, 2);
}

TEST_F(ViewModelTest, AfterAFailedReloadTheOldSceneStays) {
    ViewModel model(options());
    const auto before = rest(model);
    ASSERT_TRUE(before);
    folder_.write("box.obj", "v 0 0 0\nf 1 2 3\n");
    model.reload();
    ASSERT_TRUE(comes([&] { return !model.problem().empty(); }));
    EXPECT_NE(model.problem().find("box.obj:2"), std::string::npos) << model.problem();
    const auto after = rest(model);
    ASSERT_TRUE(after);
    EXPECT_EQ(after->image.pixels, before->image.pixels);
    folder_.write("box.obj",
                  std::string(kFloorAndBox) + "v 0 0 -1\nv 1 0 -1\nv 0 1 -1\nf 9 10 11\n");
    model.reload();
    EXPECT_TRUE(comes([&] { return rest(model)->image.pixels != before->image.pixels; }));
}

TEST_F(ViewModelTest, WhatCannotBeDrawnIsSaidAndUndone) {
    ViewModel model(options());
    const auto before = rest(model);
    ASSERT_TRUE(before);
    model.change([](ViewState& s) { s.settings.grid.tile = 0; });
    ASSERT_TRUE(comes([&] { return !model.problem().empty(); }));
    EXPECT_EQ(model.picture(), before);
    model.change([](ViewState& s) { s.settings.grid.tile = 4; });
    EXPECT_TRUE(rest(model));
    EXPECT_EQ(model.problem(), "");
}

TEST_F(ViewModelTest, APathIsToldAndDrawnRayByRay) {
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

TEST_F(ViewModelTest, ATilesListsAreTold) {
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

TEST_F(ViewModelTest, AnAnimatedScenePlaysAndPauses) {
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

TEST_F(ViewModelTest, AnotherSceneIsOpenedAndABadOneIsNot) {
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

TEST_F(ViewModelTest, ThreadsAndToneMappingChange) {
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

TEST_F(ViewModelTest, MemoryDoesNotGrowFromFrameToFrame) {
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

TEST_F(ViewModelTest, EndsAtOnceWhateverItDoes) {
    CommonOptions common = options();
    common.samples.reset();
    common.size = ImageSize{800, 600};
    for (const int ms : {0, 5, 50, 300}) {
        auto model = std::make_unique<ViewModel>(common);
        std::this_thread::sleep_for(std::chrono::milliseconds(ms));
        model.reset();
    }
}

} // namespace
} // namespace dirt
