// The viewer without its window: what it shows at rest, while things move, and when something
// fails.

#include "app/viewer/view_model.h"

#include "app/viewer/status_file.h"
#include "core/frame/renderer.h"
#include "tests/viewer/view_model_fixture.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <thread>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace dirt {
namespace {

using test::kFloorAndBox;

class ViewAtRest : public test::ViewModelTest {};

TEST_F(ViewAtRest, AtRestIsWhatRenderGives) {
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

TEST_F(ViewAtRest, ChangesAreDrawnAndTellWhichTheyAre) {
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

TEST_F(ViewAtRest, WhileTheCameraMovesPicturesAreCoarse) {
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

/// One that takes its time is not waited for with nothing to look at.
TEST_F(ViewAtRest, BeforeASlowPictureThereIsACoarseOne) {
    CommonOptions common = options();
    common.samples = 1;
    double ms = 0.0;
    for (int width = 800; ms < 500.0; width *= 2) { // on however fast a machine
        common.size = ImageSize{width, width / 2};
        ViewModel model(common);
        std::shared_ptr<const ViewPicture> first;
        ASSERT_TRUE(comes([&] { return (first = model.picture()) != nullptr; }));
        ms = rest(model)->sampleMs;
        if (ms < 500.0) continue;
        EXPECT_LT(first->width, width) << "how long it takes is not known yet";
        model.change([](ViewState& s) { s.settings.bounces = 3; });
        const uint64_t change = model.changes();
        ASSERT_TRUE(comes([&] { return (first = model.picture())->change == change; }));
        EXPECT_LT(first->width, width);
        EXPECT_FALSE(first->done);
        const auto fine = rest(model);
        ASSERT_TRUE(fine);
        EXPECT_EQ(fine->width, width);
    }
}

TEST_F(ViewAtRest, WhatCannotBeLoadedIsSaidAndMayComeLater) {
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

TEST_F(ViewAtRest, AfterAFailedReloadTheOldSceneStays) {
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

TEST_F(ViewAtRest, WhatCannotBeDrawnIsSaidAndUndone) {
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

TEST_F(ViewAtRest, EndsAtOnceWhateverItDoes) {
    CommonOptions common = options();
    common.samples.reset();
    common.size = ImageSize{800, 600};
    for (const int ms : {0, 5, 50, 300}) {
        auto model = std::make_unique<ViewModel>(common);
        std::this_thread::sleep_for(std::chrono::milliseconds(ms));
        model.reset();
    }
}

/// A scene of many objects side by side, all of which have the content of one.
class LoadingTest : public test::ViewModelTest {
protected:
    CommonOptions manyObjects(size_t count) {
        CommonOptions common = options();
        std::string obj = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
        for (int i = 0; i < 40000; ++i) obj += "v 0.125 0.25 0.5\n";
        const std::string first = folder_.write("first.obj", obj);
        std::string scene =
            "<world background='0 0 0'><user position='0 0 9' lookat='0 0 0'/><camera "
            "aperture='90'/><light position='0 0 9' target='0 0 0' flux='2000' aperture='120'/>";
        for (size_t i = 0; i < count; ++i) {
            const std::string name = "o" + std::to_string(i) + ".obj";
            std::filesystem::remove(folder_ / name);
            std::filesystem::create_hard_link(first, folder_ / name);
            const double place = 16.0 * (double) i / (double) count - 8.0;
            scene += "<transformation translation='" + std::to_string(place) +
                     " 0 0'><object file='" + name + "'/></transformation>";
        }
        common.scene = folder_.write("many.scene", scene + "</world>");
        common.size = ImageSize{96, 64};
        common.bounces = 1;
        return common;
    }

    static bool hasBegun(const ViewModel& model) {
        const auto loading = model.loading();
        return !loading || loading->done > 0;
    }

    static int litPixels(const Image& image) {
        return (int) std::count_if(image.pixels.begin(), image.pixels.end(),
                                   [](const glm::vec3& p) { return p.x > 0.0f; });
    }
};

TEST_F(LoadingTest, SaysHowFarItIsAndShowsWhatIsThere) {
    bool isPartial = false;
    for (size_t count = 50; !isPartial && count <= 3200; count *= 2) { // on however fast a machine
        ViewModel model(manyObjects(count));
        ASSERT_TRUE(model.loading());
        writeStatus(folder_ / "status.json", Viewer{model}, nullptr);
        const auto status = nlohmann::json::parse(test::readFile(folder_ / "status.json"));
        EXPECT_LE(status["loading"]["done"], status["loading"]["of"]);
        LoadingProgress last;
        std::shared_ptr<const ViewPicture> part;
        while (const auto loading = model.loading()) {
            EXPECT_LE(last.done, loading->done);
            EXPECT_LE(loading->done, count);
            EXPECT_EQ(loading->of, loading->done > 0 ? count : 0);
            last = *loading;
            const auto picture = model.picture();
            if (!part && picture && picture->loading) part = picture;
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        ASSERT_TRUE(model.loaded()) << model.problem();
        const auto whole = rest(model);
        ASSERT_TRUE(whole);
        EXPECT_FALSE(whole->loading);
        writeStatus(folder_ / "status.json", Viewer{model}, nullptr);
        EXPECT_TRUE(
            nlohmann::json::parse(test::readFile(folder_ / "status.json")).at("loading").is_null());
        EXPECT_GT(last.done, 0u);
        if (!part) continue;
        EXPECT_FALSE(part->done);
        EXPECT_LT(part->change, whole->change);
        const double lit = (double) litPixels(part->image) / (part->width * part->height);
        isPartial = lit > 0.0 && lit < 0.8 * litPixels(whole->image) / (96 * 64);
    }
    EXPECT_TRUE(isPartial);
}

TEST_F(LoadingTest, IsGivenUpForTheEndOrForAnotherOne) {
    using Clock = std::chrono::steady_clock;
    const CommonOptions common = manyObjects(60);
    const auto start = Clock::now();
    auto model = std::make_unique<ViewModel>(common);
    ASSERT_TRUE(comes([&] { return model->loaded(); }));
    const auto whole = Clock::now() - start;
    // While the scene is read again, and before there is one.
    model->reload();
    for (int round = 0; round < 2; ++round) {
        ASSERT_TRUE(comes([&] { return hasBegun(*model); }));
        const auto end = Clock::now();
        model.reset();
        EXPECT_LT(Clock::now() - end, whole / 2);
        model = std::make_unique<ViewModel>(common);
    }
    // Begun again, it comes to the end.
    ASSERT_TRUE(comes([&] { return hasBegun(*model); }));
    model->reload();
    EXPECT_TRUE(model->loading());
    EXPECT_TRUE(rest(*model));
    EXPECT_EQ(model->problem(), "");
    EXPECT_FALSE(model->loading());
}

} // namespace
} // namespace dirt
