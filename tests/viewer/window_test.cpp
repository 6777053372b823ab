// The viewer's window on a display of its own, driven by synthetic keys: each has its effect, sizes
// and backends change, errors are said, and it goes on. Xvfb and xdotool are needed.

#include "app/viewer/keys.h"
#include "core/io/image.h"
#include "tests/support/temporary_folder.h"
#include "tests/viewer/process.h"
#include "tests/viewer/screen.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iostream>
#include <memory>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include <unistd.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace dirt {
namespace {

using nlohmann::json;

constexpr const char* kBox = "v -2 0 -4\nv 2 0 -4\nv 2 0 1\nv -2 0 1\n"
                             "v -1 0 -3\nv 1 0 -3\nv 1 1.5 -3\nv -1 1.5 -3\n"
                             "f 1 4 3 2\nf 5 6 7 8\n";

class WindowTest : public testing::Test {
protected:
    /// A display, and the viewer on it.
    void open(const std::string& scene, const std::vector<std::string>& options) {
        for (const char* tool : {"Xvfb", "xdotool"})
            if (std::system((std::string("command -v ") + tool + " > /dev/null").c_str()) != 0)
                GTEST_SKIP() << "needs " << tool;
        int ends[2];
        ASSERT_EQ(pipe(ends), 0);
        const std::string folder = folder_.path().string();
        display_ = std::make_unique<test::Process>(
            std::vector<std::string>{"Xvfb", "-displayfd", "3", "-screen", "0", "1300x800x24",
                                     "-nolisten", "tcp", "-fbdir", folder},
            ends[1]);
        close(ends[1]);
        std::string number; // which it may write in parts, before the end of the line
        for (char c = 0; read(ends[0], &c, 1) == 1 && c != '\n';) number += c;
        close(ends[0]);
        ASSERT_FALSE(number.empty()) << "Xvfb does not start";
        setenv("DISPLAY", (":" + number).c_str(), 1);
        status_ = folder + "/status.json";
        std::filesystem::remove(status_);
        ASSERT_EQ(chdir(folder.c_str()), 0);
        std::vector<std::string> command{DIRT_PROGRAM, "view",       scene,    "--status",
                                         status_,      "--no-cache", "--quiet"};
        command.insert(command.end(), options.begin(), options.end());
        viewer_ = std::make_unique<test::Process>(command);
        if (!comes([&] { return now().contains("picture"); })) {
            const int ended = viewer_->wait();
            if (ended == 3) GTEST_SKIP() << "this build has no window, or the display no OpenGL";
            FAIL() << "ended with " << ended;
        }
        ASSERT_TRUE(run("xdotool search --sync --name dirt windowfocus --sync"));
    }
    void SetUp() override {
        scene_ = folder_.write("box.obj", kBox);
        open(scene_, {"--size", "320x200", "--tile", "16", "--bins", "4", "--spp", "3"});
    }
    void TearDown() override {
        viewer_.reset(), display_.reset();
        ASSERT_EQ(chdir("/"), 0);
    }

    Picture screen() const { return test::readScreen(folder_.path()); }

    /// Waits until the picture has all that it will have.
    bool rests() const {
        return comes([&] {
            json status = now(); // which may say nothing yet
            return status["picture"]["done"] == true &&
                   status["picture"]["change"] == status["changes"];
        });
    }

    static bool run(const std::string& command) {
        return std::system((command + " > /dev/null 2>&1").c_str()) == 0;
    }

    /// What the status file says; empty before there is one.
    json now() const {
        if (!std::filesystem::exists(status_)) return json::object();
        return json::parse(test::readFile(status_));
    }

    static bool comes(const std::function<bool()>& what) {
        for (int i = 0; i < 10000; ++i) {
            if (what()) return true;
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
        return false;
    }

    /// Presses a key that changes the picture, and waits for all of the new one.
    bool changes(const std::string& key) {
        const json before = now()["changes"];
        press(key);
        return comes([&] { return now()["changes"] != before; }) && rests();
    }

    static void press(const std::string& key) { run("xdotool key " + key); }

    /// Presses it and waits until \p what holds.
    void expectAfter(const std::string& key, const std::function<bool(const json&)>& what) {
        press(key);
        EXPECT_TRUE(comes([&] { return what(now()); })) << key << "\n" << now().dump(1);
    }

    test::TemporaryFolder folder_;
    std::string scene_, status_;
    std::unique_ptr<test::Process> display_, viewer_;
};

/// As xdotool calls a key.
std::string nameOf(const KeyBinding& binding) {
    const std::string label = binding.label;
    if (label == "Esc") return "Escape";
    if (label == "PgUp") return "Prior";
    if (label == "PgDn") return "Next";
    if (label == "-") return "minus";
    if (label == "=") return "equal";
    if (label == ".") return "period";
    if (label == ",") return "comma";
    if (label == "Space") return "space";
    if (label.size() == 1) return std::string(1, (char) std::tolower(label[0]));
    return label;
}

TEST_F(WindowTest, EveryKeyHasItsEffect) {
    press("f"); // so that C and V have one
    std::vector<double> latencies;
    for (const KeyBinding& binding : keyBindings()) {
        if (binding.key == kEscape) continue;
        const std::string key = nameOf(binding);
        if (binding.key == '.') { // which takes a picture that has a path
            EXPECT_TRUE(comes([&] { return now()["picture"]["steps"] > 1; }));
        }
        const json before = now();
        const auto start = std::chrono::steady_clock::now();
        run("xdotool keydown " + key);
        const bool seen = comes([&] {
            const json after = now();
            return after["changes"] != before["changes"] || after["text"] != before["text"] ||
                   after["timers"] != before["timers"] || after["help"] != before["help"] ||
                   after["panel"] != before["panel"] || after["step"] != before["step"] ||
                   after["said"] != before["said"];
        });
        const std::chrono::duration<double, std::milli> took =
            std::chrono::steady_clock::now() - start;
        run("xdotool keyup " + key);
        EXPECT_TRUE(seen) << binding.label;
        latencies.push_back(took.count());
    }
    std::sort(latencies.begin(), latencies.end());
    std::cout << "a key is seen after " << latencies[latencies.size() / 2]
              << " ms (median, with the time to send it)\n";
    press("Escape");
    EXPECT_EQ(viewer_->wait(), 0);
}

TEST_F(WindowTest, SizesAndBackendsChange) {
    EXPECT_TRUE(run("xdotool search --name '^dirt: .*box.obj$'"));
    for (const auto& [width, height] : {std::pair(333, 217), {701, 503}, {160, 301}}) {
        ASSERT_TRUE(run("xdotool search --name dirt windowsize --sync " + std::to_string(width) +
                        " " + std::to_string(height)));
        EXPECT_TRUE(comes([&] {
            const json status = now();
            return status["state"]["size"] == json({width, height}) &&
                   status["picture"]["width"] == width && status["picture"]["height"] == height;
        })) << now().dump(1);
    }
    // One of them there may not be; the window goes on.
    for (const char* backend : {"gl", "embree", "cpu"})
        expectAfter("b", [&](const json& status) {
            return status["state"]["backend"] == backend &&
                   (status["problem"] != "" || status["picture"]["change"] == status["changes"]);
        });
    EXPECT_EQ(now()["problem"], "");
}

/// The window shows the picture that F5 saves, to the bit.
TEST_F(WindowTest, ShowsThePicture) {
    expectAfter("F8", [](const json& status) { return status["text"] == false; });
    run("xdotool mousemove 900 700"); // so that nothing is said of what is below it
    for (const char* key : {"g", "m", "equal"}) {
        ASSERT_TRUE(changes(key));
        std::filesystem::remove("box-view.png"), std::filesystem::remove("box-view.exr");
        expectAfter("F5", [](const json& status) {
            return status["said"] == "saved box-view.png and .exr";
        });
        expectAfter("F8", [](const json& status) { return status["text"] == true; });
        expectAfter("F8", [](const json& status) { return status["text"] == false; });
        const Image saved = readImage("box-view.png");
        ASSERT_EQ(saved.pixels.size(), (size_t) (320 * 200));
        std::this_thread::sleep_for(std::chrono::milliseconds(500)); // some of the window's frames
        const Picture shown = screen();
        int different = 0;
        for (int y = 0; y < 200; ++y)
            for (int x = 0; x < 320; ++x)
                for (int c = 0; c < 3; ++c) {
                    const float due = saved.pixels[(size_t) (y * 320 + x)][c];
                    different += std::lround(255.0f * due) != (long) shown.at(x, y)[c];
                }
        EXPECT_EQ(different, 0) << key;
    }
}

TEST_F(WindowTest, TheMouseTurnsZoomsAndTells) {
    ASSERT_TRUE(rests());
    run("xdotool mousemove 200 150");
    EXPECT_TRUE(comes([&] {
        return now()["under"].get<std::string>().find("pixel (200, 150): ") == 0;
    })) << now()["under"];
    const json before = now()["state"];
    run("xdotool mousedown 1 mousemove 230 140 mouseup 1");
    EXPECT_TRUE(comes([&] { return now()["state"]["target"] != before["target"]; }));
    EXPECT_EQ(now()["state"]["eye"], before["eye"]);
    ASSERT_TRUE(rests());
    run("xdotool mousemove 100 100 click 4 click 4 click 4");
    EXPECT_TRUE(comes([&] { return now()["zoom"] > 1.9; }));
    EXPECT_TRUE(comes([&] { // the point at the cursor stays there
        return now()["under"].get<std::string>().find("pixel (100, 100): ") == 0;
    })) << now()["under"];
    run("xdotool mousedown 3 mousemove 140 120 mouseup 3 mousemove 100 100");
    EXPECT_TRUE(comes([&] { // by 40 and 20 pixels of the window
        return now()["under"].get<std::string>().find("pixel (79, 89): ") == 0;
    })) << now()["under"];
    run("xdotool click 5 click 5 click 5 click 5");
    EXPECT_TRUE(comes([&] { return now()["zoom"] == 1.0; }));
    // A click says the value, with - it chooses the pixel.
    run("xdotool mousemove 60 160 click 1");
    EXPECT_TRUE(comes([&] {
        return now()["said"].get<std::string>().find("pixel (60, 160): ") == 0;
    })) << now()["said"];
    expectAfter("minus", [](const json& status) { return status["picture"]["steps"] > 1; });
    run("xdotool mousemove 61 161 click 1");
    EXPECT_TRUE(comes([&] { return now()["state"]["ray"] == json({61, 161}); }));
    EXPECT_TRUE(comes([&] {
        const json picture = now()["picture"];
        return picture.contains("ray_told") &&
               picture["ray_told"].get<std::string>().find("pixel (61, 161)") == 0;
    }));
}

TEST_F(WindowTest, AClickTellsATilesLists) {
    press("g"), press("p"), press("2"), press("2"),
        press("2"); // image, overview, near, far, entries
    expectAfter("F8", [](const json& status) { return status["state"]["shown"] == "entries"; });
    ASSERT_TRUE(rests());
    run("xdotool mousemove 160 110");
    ASSERT_TRUE(comes([&] {
        return now()["under"].get<std::string>().find("view 0, tile (") == 0;
    })) << now()["under"];
    run("xdotool click 1");
    EXPECT_TRUE(comes([&] {
        const json told = now()["picture"]["told"];
        return told.get<std::string>().find("0 wrong") != std::string::npos;
    })) << now()["picture"]["told"];
    run("xdotool click 1");
    EXPECT_TRUE(comes([&] { return now()["picture"]["told"] == ""; }));
}

/// The panel is found by its colours: a bar above, and handles of sliders.
TEST_F(WindowTest, ThePanelChangesSettings) {
    run("xdotool search --name dirt windowsize --sync 700 640");
    ASSERT_TRUE(comes([&] { return now()["state"]["size"] == json({700, 640}); }));
    expectAfter("F8", [](const json& status) { return status["text"] == false; });
    expectAfter("Tab", [](const json& status) { return status["panel"] == true; });
    const Colour handle(61, 133, 224);
    glm::ivec2 first(-1);
    ASSERT_TRUE(comes([&] {
        const Picture shown = screen();
        for (int y = 0; y < 640 && first.x < 0; ++y)
            for (int x = 0; x < 700 && first.x < 0; ++x)
                if (shown.at(x, y) == handle) first = {x, y};
        return first.x >= 0;
    }));
    // That of the tile, which is 16 of 1 to 64: up to the right end.
    const auto at = [](glm::ivec2 p) {
        return "xdotool mousemove " + std::to_string(p.x) + " " + std::to_string(p.y);
    };
    run(at(first + glm::ivec2(3, 4)) + " sleep 0.3 mousedown 1 sleep 0.3");
    run(at(first + glm::ivec2(160, 4)) + " sleep 0.3 mouseup 1");
    EXPECT_TRUE(comes([&] { return now()["state"]["tile"] == 64; })) << now().dump(1);
    expectAfter("Tab", [](const json& status) { return status["panel"] == false; });
}

/// What a shader's error is said of, and that the picture goes on with the one before.
TEST_F(WindowTest, ABrokenShaderIsSaidAndTheOldOneStays) {
    TearDown();
    const auto shaders = folder_.path() / "shaders";
    std::filesystem::copy(DIRT_SOURCE_DIR "/shaders", shaders,
                          std::filesystem::copy_options::recursive);
    setenv("DIRT_SHADERS", shaders.c_str(), 1);
    open(scene_, {"--size", "64x48", "--spp", "1", "--backend", "gl"});
    unsetenv("DIRT_SHADERS");
    if (IsSkipped() || HasFatalFailure()) return;
    if (!rests()) GTEST_SKIP() << now()["problem"];
    const std::string good = test::readFile(shaders / "shade.comp");
    std::ofstream(shaders / "shade.comp") << "#version 450 core\nbroken\n";
    expectAfter("r", [](const json& status) {
        return status["problem"].get<std::string>().find("shade.comp:2") != std::string::npos;
    });
    EXPECT_TRUE(changes("4")) << "with what there is";
    EXPECT_EQ(now()["problem"], "");
    std::ofstream(shaders / "shade.comp") << good;
    EXPECT_TRUE(changes("r"));
    EXPECT_EQ(now()["problem"], "");
}

/// The pictures of docs/viewer.md: of $DIRT_VIEWER_SCENE, into $DIRT_VIEWER_PICTURES. By default of
/// the box, to see that they show something.
TEST_F(WindowTest, TakesThePicturesOfTheDocument) {
    const char* const scene = std::getenv("DIRT_VIEWER_SCENE");
    const char* const pictures = std::getenv("DIRT_VIEWER_PICTURES");
    TearDown();
    const bool isLarge = scene != nullptr;
    open(isLarge ? scene : scene_,
         {"--size", isLarge ? "1280x720" : "480x320", "--spp", isLarge ? "8" : "2", "--tile", "16",
          "--title", "dirt's pictures"});
    if (IsSkipped() || HasFatalFailure()) return;
    EXPECT_TRUE(run("xdotool search --name \"^dirt's pictures$\""));
    const auto take = [&](const std::string& name) {
        ASSERT_TRUE(rests());
        ASSERT_TRUE(comes([&] { return now()["picture"]["done"] == true; }));
        std::this_thread::sleep_for(std::chrono::milliseconds(500)); // a few of the window's frames
        const json size = now()["state"]["size"];
        const Picture whole = screen();
        Picture window((int) size[0], (int) size[1]);
        std::set<std::array<uint8_t, 3>> colours;
        for (int y = 0; y < window.height; ++y)
            for (int x = 0; x < window.width; ++x) {
                const Colour colour = whole.at(x, y);
                window.set(x, y, colour);
                colours.insert({colour.x, colour.y, colour.z});
            }
        EXPECT_GT(colours.size(), 20u) << name;
        if (pictures)
            writePng(std::string(pictures) + "/viewer-" + name + ".png", window.width,
                     window.height, window.rgb, {});
    };
    press("Tab");
    take("panel");
    press("Tab");
    ASSERT_TRUE(changes("minus"));
    take("ray");
    ASSERT_TRUE(changes("p"));
    press("period"), press("period"), press("period");
    take("overview");
    for (const char* key : {"minus", "2", "2", "2"}) ASSERT_TRUE(changes(key));
    const json size = now()["state"]["size"];
    run("xdotool mousemove " + std::to_string((int) size[0] / 5) + " " +
        std::to_string((int) size[1] * 2 / 3) + " click 1");
    take("tile");
}

TEST_F(WindowTest, ABrokenSceneIsSaidAndTheOldOneStays) {
    folder_.write("box.obj", "v 0 0 0\nf 1 2 3\n");
    expectAfter("r", [](const json& status) {
        return status["problem"].get<std::string>().find("box.obj:2") != std::string::npos;
    });
    EXPECT_TRUE(now()["loaded"]);
    folder_.write("box.obj", kBox);
    expectAfter("r", [](const json& status) {
        return status["problem"] == "" && status["picture"]["change"] == status["changes"];
    });
}

} // namespace
} // namespace dirt
