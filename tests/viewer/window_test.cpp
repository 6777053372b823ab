// The viewer's window on a display of its own, driven by synthetic keys: each has its effect, sizes
// and backends change, errors are said, and it goes on. Xvfb and xdotool are needed.

#include "app/viewer/keys.h"
#include "tests/support/temporary_folder.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace dirt {
namespace {

using nlohmann::json;

constexpr const char* kBox = "v -2 0 -4\nv 2 0 -4\nv 2 0 1\nv -2 0 1\n"
                             "v -1 0 -3\nv 1 0 -3\nv 1 1.5 -3\nv -1 1.5 -3\n"
                             "f 1 4 3 2\nf 5 6 7 8\n";

/// A program that ends with this.
class Process {
public:
    explicit Process(const std::vector<std::string>& command, int output = -1) {
        id_ = fork();
        if (id_ != 0) return;
        if (output >= 0) dup2(output, 3);
        std::vector<char*> words;
        for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
        words.push_back(nullptr);
        execvp(words[0], words.data());
        _exit(127);
    }
    ~Process() {
        if (id_ > 0) kill(id_, SIGTERM), wait();
    }
    /// Its exit status.
    int wait() {
        int status = 0;
        waitpid(id_, &status, 0);
        id_ = 0;
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }

private:
    pid_t id_ = 0;
};

class WindowTest : public testing::Test {
protected:
    void SetUp() override {
        for (const char* tool : {"Xvfb", "xdotool"})
            if (std::system((std::string("command -v ") + tool + " > /dev/null").c_str()) != 0)
                GTEST_SKIP() << "needs " << tool;
        int ends[2];
        ASSERT_EQ(pipe(ends), 0);
        display_ = std::make_unique<Process>(std::vector<std::string>{"Xvfb", "-displayfd", "3",
                                                                      "-screen", "0", "1000x800x24",
                                                                      "-nolisten", "tcp"},
                                             ends[1]);
        close(ends[1]);
        std::string number; // which it may write in parts, before the end of the line
        for (char c = 0; read(ends[0], &c, 1) == 1 && c != '\n';) number += c;
        close(ends[0]);
        ASSERT_FALSE(number.empty()) << "Xvfb does not start";
        setenv("DISPLAY", (":" + number).c_str(), 1);
        scene_ = folder_.write("box.obj", kBox);
        status_ = (folder_.path() / "status.json").string();
        ASSERT_EQ(chdir(folder_.path().c_str()), 0);
        viewer_ = std::make_unique<Process>(std::vector<std::string>{
            DIRT_PROGRAM, "view", scene_, "--size", "320x200", "--tile", "16", "--bins", "4",
            "--status", status_, "--no-cache", "--quiet"});
        if (!comes([&] { return now().contains("picture"); })) {
            const int ended = viewer_->wait();
            if (ended == 3) GTEST_SKIP() << "this build has no window, or the display no OpenGL";
            FAIL() << "ended with " << ended;
        }
        ASSERT_TRUE(run("xdotool search --sync --name dirt windowfocus --sync"));
    }
    void TearDown() override {
        viewer_.reset(), display_.reset();
        ASSERT_EQ(chdir("/"), 0);
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

    static void press(const std::string& key) { run("xdotool key " + key); }

    /// Presses it and waits until \p what holds.
    void expectAfter(const std::string& key, const std::function<bool(const json&)>& what) {
        press(key);
        EXPECT_TRUE(comes([&] { return what(now()); })) << key << "\n" << now().dump(1);
    }

    test::TemporaryFolder folder_;
    std::string scene_, status_;
    std::unique_ptr<Process> display_, viewer_;
};

/// As xdotool calls a key.
std::string nameOf(const KeyBinding& binding) {
    const std::string label = binding.label;
    if (label == "Esc") return "Escape";
    if (label == "PgUp") return "Prior";
    if (label == "PgDn") return "Next";
    if (label == "-") return "minus";
    if (label == "=") return "equal";
    if (label.size() == 1) return std::string(1, (char) std::tolower(label[0]));
    return label;
}

TEST_F(WindowTest, EveryKeyHasItsEffect) {
    press("f"); // so that C and V have one
    std::vector<double> latencies;
    for (const KeyBinding& binding : keyBindings()) {
        if (binding.key == kEscape) continue;
        const std::string key = nameOf(binding);
        const json before = now();
        const auto start = std::chrono::steady_clock::now();
        run("xdotool keydown " + key);
        const bool seen = comes([&] {
            const json after = now();
            return after["changes"] != before["changes"] || after["text"] != before["text"] ||
                   after["timers"] != before["timers"] || after["help"] != before["help"] ||
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
