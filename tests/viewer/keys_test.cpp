// Every key has the effect that the list says, as the status file tells it.

#include "app/viewer/keys.h"

#include "app/cli/log.h"
#include "app/viewer/status_file.h"
#include "core/io/image.h"
#include "tests/support/captured_stream.h"
#include "tests/support/temporary_folder.h"

#include <chrono>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <thread>

#include <sys/resource.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace dirt {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class Keys : public testing::Test {
protected:
    Keys() : before_(fs::current_path()) {
        fs::current_path(folder_.path()); // where F5 writes to
        CommonOptions& options = options_;
        options.scene = folder_.write("box.obj", "v -1 0 -4\nv 1 0 -4\nv 0 2 -4\nf 1 2 3\n");
        options.size = ImageSize{24, 16};
        options.samples = 1;
        options.tile = 16, options.bins = 4; // where steps lead both ways
        options.threads = 1;
        options.quiet = options.noCache = true;
        model_ = std::make_unique<ViewModel>(options);
        while (!model_->picture()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
        viewer_ = std::make_unique<Viewer>(*model_);
    }
    ~Keys() override { fs::current_path(before_); }

    /// The status, without what goes on by itself.
    json status() {
        const std::string file = (folder_.path() / "status.json").string();
        writeStatus(file, *viewer_, model_->picture().get());
        json read = json::parse(test::readFile(file));
        read.erase("picture");
        read.erase("changes");
        return read;
    }
    json state() { return status()["state"]; }

    json press(int key) {
        keyBinding(key)->press(*viewer_);
        return state();
    }

    test::TemporaryFolder folder_;
    fs::path before_;
    CommonOptions options_;
    std::unique_ptr<ViewModel> model_;
    std::unique_ptr<Viewer> viewer_;
};

TEST_F(Keys, EachIsThereOnceAndDoesSomething) {
    std::set<int> seen;
    for (const KeyBinding& binding : keyBindings()) {
        EXPECT_TRUE(seen.insert(binding.key).second) << binding.label;
        EXPECT_TRUE((binding.press != nullptr) != (binding.hold != nullptr)) << binding.label;
        EXPECT_EQ(keyBinding(binding.key), &binding);
        if (binding.key == 'C' || binding.key == 'V') continue; // of a lens that is on; below
        const json before = status();
        const uint64_t changes = model_->changes();
        if (binding.press)
            binding.press(*viewer_);
        else
            binding.hold(*viewer_, 0.5);
        EXPECT_TRUE(status() != before || model_->changes() != changes || viewer_->quit)
            << binding.label << ": nothing happens";
    }
    EXPECT_EQ(keyBinding('@'), nullptr);
}

TEST_F(Keys, AreAllInTheDocument) {
    const std::string page = test::readFile(DIRT_SOURCE_DIR "/docs/viewer.md");
    size_t at = 0;
    for (const KeyBinding& binding : keyBindings()) {
        const std::string row =
            std::string("\n| `") + binding.label + "` | " + binding.meaning + " |\n";
        at = page.find(row, at);
        ASSERT_NE(at, std::string::npos) << row;
        at += row.size() - 1;
    }
}

TEST_F(Keys, PairsGoBothWays) {
    const json start = state();
    for (const auto& [there, back] : {std::pair('3', '4'), {'5', '6'}, {'7', '8'}, {'2', '1'}}) {
        EXPECT_NE(press(there), start) << there;
        EXPECT_EQ(press(back), start) << back;
    }
    for (const int key : {'F', 'G', 'M', 'P', 'Q', '-'}) {
        EXPECT_NE(press(key), start) << (char) key;
        EXPECT_EQ(press(key), start) << (char) key;
    }
    for (int i = 0; i < 4; ++i) press('=');
    EXPECT_EQ(press('='), start);
}

TEST_F(Keys, ValuesStayWithinTheirRange) {
    for (int i = 0; i < 300; ++i) press('5');
    EXPECT_EQ(state()["bins"], 256);
    for (int i = 0; i < 300; ++i) press('6');
    EXPECT_EQ(state()["bins"], 1);
    for (int i = 0; i < 10; ++i) press('7');
    EXPECT_EQ(state()["tile"], 64);
    for (int i = 0; i < 10; ++i) press('8');
    EXPECT_EQ(state()["tile"], 1);
    for (int i = 0; i < 10; ++i) press('4');
    EXPECT_EQ(state()["bounces"], 1);
    for (int i = 0; i < 20; ++i) press('0');
    EXPECT_EQ(state()["max_mip"], 0);
    for (int i = 0; i < 20; ++i) press('9');
    EXPECT_EQ(state()["max_mip"], -1);
}

TEST_F(Keys, TheLensKeepsItsWidthWhileItIsOff) {
    press('F');
    const double width = state()["aperture_radius"];
    EXPECT_GT(width, 0.0);
    EXPECT_GT(press('C')["aperture_radius"], width);
    press('V');
    const double narrow = press('V')["aperture_radius"];
    EXPECT_LT(narrow, width);
    EXPECT_EQ(press('F')["aperture_radius"], 0.0);
    EXPECT_EQ(press('F')["aperture_radius"], narrow);
    const double focus = state()["focal_distance"];
    EXPECT_GT(press('Z')["focal_distance"], focus);
    press('X');
    EXPECT_LT(press('X')["focal_distance"], focus);
}

TEST_F(Keys, StepAlongThePath) {
    press('.');
    EXPECT_NE(viewer_->said.find("no rays"), std::string::npos);
    press('-');
    const auto steps = [&] { return (int) model_->picture()->path.size(); };
    for (int i = 0; i < 2000 && steps() == 0; ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    ASSERT_GT(steps(), 1); // all rays, and each
    const uint64_t changes = model_->changes();
    std::set<std::string> texts;
    for (int i = 0; i < steps(); ++i) {
        EXPECT_EQ(viewer_->step, i);
        texts.insert(viewer_->stepOf(*model_->picture())->text);
        press('.');
    }
    EXPECT_EQ((int) texts.size(), steps());
    EXPECT_EQ(viewer_->step, 0);
    press(',');
    EXPECT_EQ(viewer_->step, steps() - 1);
    EXPECT_EQ(model_->changes(), changes) << "steps draw nothing anew";
    press('-');
    EXPECT_EQ(viewer_->step, 0);
}

TEST_F(Keys, PicturesAreSavedBesideEarlierOnes) {
    press(kF5);
    EXPECT_TRUE(fs::exists("box-view.png") && fs::exists("box-view.exr"));
    press(kF5);
    EXPECT_TRUE(fs::exists("box-view-2.png") && fs::exists("box-view-2.exr"));
    EXPECT_EQ(viewer_->said, "saved box-view-2.png and .exr");
    // Of a buffer the values, as the views stand in the picture.
    model_->change([](ViewState& s) { s.shown = previewKind("near"); });
    for (int i = 0; i < 2000 && model_->picture()->values.empty(); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    press(kF5);
    const Image saved = readImage("box-view-3.exr");
    const std::vector<PictureValues>& values = model_->picture()->values;
    ASSERT_EQ(values.size(), 6u);
    EXPECT_EQ(saved.width, 3 * values[0].columns());
    EXPECT_EQ(saved.height, 2 * values[0].rows());
    size_t found = 0;
    for (int y = 0; y < values[5].rows(); ++y) // -Z, which the triangle is in
        for (int x = 0; x < values[5].columns(); ++x) {
            const double number = values[5].numbers[(size_t) (y * values[5].columns() + x)];
            const glm::vec3 pixel = saved.pixels[(size_t) ((values[5].rows() + y) * saved.width +
                                                           2 * values[5].columns() + x)];
            found += !std::isnan(number);
            EXPECT_TRUE(std::isnan(number) ? std::isnan(pixel.x) : number == (double) pixel.x);
        }
    EXPECT_GT(found, 0u);
    // Of an overview those of its image, also where its cells and pixels are drawn as large.
    model_->change([](ViewState& s) {
        s.shown = previewKind("overview");
        s.settings.grid.tile = 1, s.settings.grid.mode = ViewMode::single;
    });
    const auto hasImage = [&] { return model_->picture()->values.size() == 2; };
    for (int i = 0; i < 2000 && !hasImage(); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    ASSERT_TRUE(hasImage());
    EXPECT_EQ(model_->picture()->values[0].times, model_->picture()->values[1].times);
    press(kF5);
    EXPECT_EQ(readImage("box-view-4.exr").width, 24);
    EXPECT_EQ(readImage("box-view-4.exr").height, 16);
}

TEST_F(Keys, WhatTheySayIsInTheLog) {
    const char* argv[] = {"dirt", "view"};
    const test::CapturedStream err(stderr);
    const std::string file = (folder_.path() / "log").string();
    Log log(2, argv);
    log.open(file);
    press(kF6);
    const std::string camera = viewer_->said;
    press(kF5);
    // The window shows what the drawing thread finds.
    folder_.write("box.obj", "f 1 2 3\n");
    model_->reload();
    while (model_->problem().empty()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    const std::string text = test::readFile(file);
    size_t at = 0;
    for (const std::string& line :
         {"note: " + camera + "\n", std::string("note: <camera name=\"view\" aperture=\""),
          std::string("note: <user name=\"default_user\" position=\""),
          std::string("note: saved box-view.png and .exr\n"),
          "error: " + model_->problem() + "\n"}) {
        at = text.find("Z " + line, at);
        ASSERT_NE(at, text.npos) << line << text;
    }
}

/// Of what is ahead: a depth buffer's, which a rasterizer needs.
TEST_F(Keys, TheCameraIsLoggedWithPlanesThatHoldTheScene) {
    const auto logged = [&](glm::vec3 eye, glm::vec3 target) {
        model_->change([&](ViewState& s) { s.camera.eye = eye, s.camera.target = target; });
        test::CapturedStream err(stderr);
        press(kF6);
        return err.text();
    };
    const auto has = [](const std::string& text, const char* part) {
        return text.find(part) != text.npos;
    };
    std::string text = logged({0, 1, 0}, {0, 1, -1});
    EXPECT_TRUE(has(text, "\" near=\"4\" far=\"4\"/>")) << text;
    text = logged({-3, 1, -4}, {0, 1, -4});
    EXPECT_TRUE(has(text, "\" near=\"2\" far=\"4\"/>")) << text;
    text = logged({0, 1, -4}, {1, 1, -4}); // within it
    EXPECT_TRUE(has(text, "\" near=\"1e-05\" far=\"1\"/>")) << text;
    text = logged({0, 1, 0}, {0, 1, 1});
    EXPECT_TRUE(has(text, "<camera")) << text;
    EXPECT_FALSE(has(text, "near")) << text;
}

TEST_F(Keys, AFullDiskIsSaidAndEndsNothing) {
    const auto before = model_->picture();
    std::signal(SIGXFSZ, SIG_IGN); // a limit of files, which is the disk
    rlimit limit;
    getrlimit(RLIMIT_FSIZE, &limit);
    rlimit full = limit;
    full.rlim_cur = 50;
    setrlimit(RLIMIT_FSIZE, &full);
    keyBinding(kF5)->press(*viewer_);
    setrlimit(RLIMIT_FSIZE, &limit);
    EXPECT_NE(viewer_->said.find("box-view.png: cannot write"), std::string::npos) << viewer_->said;
    for (const auto& entry : fs::directory_iterator(folder_.path()))
        EXPECT_EQ(entry.path().filename().string().find("view"), std::string::npos) << entry.path();
    EXPECT_EQ(model_->picture(), before);
    press(kF5);
    EXPECT_EQ(viewer_->said, "saved box-view.png and .exr");
}

TEST_F(Keys, TheCameraIsLoggedAsOptionsThatGiveItAgain) {
    // Where float32 has a digit to spare, and far off, where the scene has an origin of its own.
    for (const char* corners : {"v -1 0 -4\nv 1 0 -4\nv 0 2 -4\n",
                                "v 50000001 0 -4\nv 50000003 0 -4\nv 50000002 2 -4\n"}) {
        CommonOptions options = options_;
        options.scene = folder_.write("there.obj", std::string(corners) + "f 1 2 3\n");
        ViewModel model(options);
        while (!model.picture()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
        Viewer viewer{model};
        dragView(viewer, 40, -20);
        keyBinding(kUp)->hold(viewer, 0.3);
        keyBinding(kF6)->press(viewer);
        double eye[3], target[3], up[3], fov = 0;
        ASSERT_EQ(std::sscanf(viewer.said.c_str(),
                              "--eye %lf,%lf,%lf --target %lf,%lf,%lf --up %lf,%lf,%lf --fov %lf",
                              eye, eye + 1, eye + 2, target, target + 1, target + 2, up, up + 1,
                              up + 2, &fov),
                  10)
            << viewer.said;
        options.eye = glm::dvec3(eye[0], eye[1], eye[2]);
        options.target = glm::dvec3(target[0], target[1], target[2]);
        options.up = glm::vec3((float) up[0], (float) up[1], (float) up[2]);
        options.verticalFov = (float) fov;
        const auto executor = makeExecutor(options);
        const Camera again = openInput(options, *executor).scene.camera;
        const Camera camera = model.state().camera;
        EXPECT_EQ(again.eye, camera.eye) << viewer.said;
        EXPECT_EQ(again.target, camera.target) << viewer.said;
        EXPECT_EQ(again.up, camera.up);
        EXPECT_EQ(again.verticalFov, camera.verticalFov);
    }
}

} // namespace
} // namespace dirt
