// Ctrl-C, SIGTERM and SIGHUP at any moment: never a part of a file, never a temporary one left,
// exit status 128 + signal, and the image that is written is the one with that many samples. Of
// SIGKILL the first two hold.

#include "core/io/image.h"
#include "tests/cli/program.h"
#include "tests/support/random.h"

#include <chrono>
#include <csignal>
#include <thread>

#include <gtest/gtest.h>

namespace dirt::test {
namespace {

/// A third of a run is rendering where the program takes half a second to start.
constexpr int kSamples = 300;

std::vector<std::string> render(const std::string& scene, int samples, const std::string& output) {
    return {"render", scene, "--size", "96x48", "--spp", std::to_string(samples), "-o", output};
}

std::string metadataOf(const std::string& image, const std::string& name) {
    for (const auto& [key, value] : readMetadata(image))
        if (key == name) return value;
    return "";
}

using Seconds = std::chrono::duration<double>;

class Interrupt : public testing::Test {
protected:
    /// Renders over an old file, with a signal after each of \p delays, and checks what is left.
    /// Returns how many samples the written image has; 0: none was written.
    int interruptedRender(const std::string& extension, const std::vector<Seconds>& delays,
                          int signal) {
        const std::string name = "a" + extension, output = folder_.write(name, "old");
        // As a shell starts it, whatever started this test.
        Process process(DIRT_PROGRAM, render(scene_, kSamples, output),
                        [signal] { ::signal(signal, SIG_DFL); });
        for (const Seconds delay : delays) {
            std::this_thread::sleep_for(delay);
            kill(process.id(), signal);
        }
        const Outcome run = process.wait();
        EXPECT_EQ(folder_.names(), (std::set<std::string>{"a.obj", "a.scene", name})) << run.err;

        const bool written = readFile(output) != "old";
        int samples = written ? kSamples : 0, wished = kSamples;
        if (run.status == 0) { // too late: all was done
            EXPECT_EQ(run.err, output + "\n");
        } else {
            EXPECT_EQ(run.status, 128 + signal) << run.err;
            // The line may be lost where a second one comes.
            if (written && (delays.size() > 1 || signal == SIGKILL)) {
                samples = std::stoi(metadataOf(output, "dirt:samples"));
            } else if (written) {
                EXPECT_EQ(std::sscanf(run.err.c_str(), "dirt: stopped after %d of %d samples\n",
                                      &samples, &wished),
                          2)
                    << run.err;
            }
        }
        EXPECT_EQ(wished, kSamples);
        if (written) {
            EXPECT_EQ(metadataOf(output, "dirt:samples"), std::to_string(samples));
            const std::string whole = folder_ / ("whole" + extension);
            EXPECT_EQ(dirt(render(scene_, samples, whole)).status, 0);
            EXPECT_TRUE(readFile(output) == readFile(whole)) << samples << " samples";
            std::filesystem::remove(whole);
        }
        std::filesystem::remove(output);
        return written ? samples : 0;
    }

    TemporaryFolder folder_;
    const std::string scene_ = litTriangle(folder_);
    const int rounds_ = cases(12, 200);
    static constexpr int kSignals[] = {SIGINT, SIGTERM, SIGHUP};
};

/// Moments spread over the whole run, before main() and after the image is written included.
TEST_F(Interrupt, LeavesTheSamplesItSays) {
    const auto start = std::chrono::steady_clock::now();
    ASSERT_EQ(startDirt(render(scene_, kSamples, folder_ / "whole.exr")).status, 0);
    std::filesystem::remove(folder_ / "whole.exr");
    const Seconds whole = std::chrono::steady_clock::now() - start;

    Random random(1);
    int partial = 0;
    for (int round = 0; round < rounds_; ++round) {
        // One moment in each of equal parts of a span that is a little longer than the run.
        const Seconds delay = 1.1 * whole * (round + random.uniform()) / rounds_;
        SCOPED_TRACE("after " + std::to_string(delay.count()) + " s");
        const int samples =
            interruptedRender(round % 2 ? ".png" : ".exr", {delay}, kSignals[round % 3]);
        partial += samples > 0 && samples < kSamples;
        if (HasFailure()) break;
    }
    EXPECT_GT(partial, 0) << "none of the moments was within the render";
}

TEST_F(Interrupt, TwiceEndsAtOnce) {
    Random random(2);
    for (int round = 0; round < rounds_ / 2; ++round) {
        const Seconds first(0.6 * random.uniform()), second(0.02 * random.uniform());
        SCOPED_TRACE("after " + std::to_string(first.count()) + " s and " +
                     std::to_string(second.count()) + " s");
        interruptedRender(round % 2 ? ".png" : ".exr", {first, second}, kSignals[round % 3]);
        if (HasFailure()) break;
    }
}

TEST_F(Interrupt, AKilledRenderLeavesNothing) {
    Random random(4);
    for (int round = 0; round < rounds_ / 2; ++round) {
        const Seconds delay(0.6 * random.uniform());
        SCOPED_TRACE("after " + std::to_string(delay.count()) + " s");
        interruptedRender(round % 2 ? ".png" : ".exr", {delay}, SIGKILL);
        if (HasFailure()) break;
    }
}

/// nohup and the like: what is ignored stays so.
TEST_F(Interrupt, IgnoredHangupsStayIgnored) {
    Process process(DIRT_PROGRAM, render(scene_, kSamples, folder_ / "a.png"),
                    [] { ::signal(SIGHUP, SIG_IGN); });
    for (int i = 0; i < 5; ++i) {
        std::this_thread::sleep_for(Seconds(0.02));
        kill(process.id(), SIGHUP);
    }
    const Outcome run = process.wait();
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(metadataOf(folder_ / "a.png", "dirt:samples"), std::to_string(kSamples));
}

/// `dirt … | head`: quietly, and a picture is written all the same.
TEST_F(Interrupt, APipeThatNobodyReadsEndsQuietly) {
    const auto intoClosedPipe = [](int stream) {
        return [stream] {
            int ends[2];
            if (pipe(ends) != 0) _exit(126);
            close(ends[0]);
            dup2(ends[1], stream);
        };
    };
    std::vector<std::string> json = render(scene_, 1, folder_ / "a.png");
    json.push_back("--json");
    for (const std::vector<std::string>& arguments : {json, {"info", scene_}, {"--help"}}) {
        const Outcome run = startDirt(arguments, intoClosedPipe(STDOUT_FILENO));
        EXPECT_EQ(run.status, 128 + SIGPIPE);
        EXPECT_EQ(run.err.find("dirt: "), std::string::npos) << run.err;
    }
    EXPECT_TRUE(std::filesystem::exists(folder_ / "a.png"));
    std::filesystem::remove(folder_ / "a.png");
    const Outcome run =
        startDirt(render(scene_, 1, folder_ / "a.png"), intoClosedPipe(STDERR_FILENO));
    EXPECT_EQ(run.status, 0);
    EXPECT_TRUE(std::filesystem::exists(folder_ / "a.png"));
}

/// generate writes many files; each is there whole or not at all.
TEST_F(Interrupt, GenerateLeavesWholeFiles) {
    if (!fullTests()) GTEST_SKIP() << "in the long form only: each run takes seconds";
    const std::string whole = folder_ / "whole", part = folder_ / "part";
    ASSERT_EQ(dirt({"generate", "atrium", "--detail", "10000", "-o", whole}).status, 0);
    Random random(3);
    for (int round = 0; round < 20; ++round) {
        Process process(DIRT_PROGRAM, {"generate", "atrium", "--detail", "10000", "-o", part},
                        [] {});
        std::this_thread::sleep_for(Seconds(4.0 * random.uniform()));
        kill(process.id(), SIGINT);
        const Outcome run = process.wait();
        EXPECT_TRUE(run.status == 130 || run.status == 0) << run.status;
        std::error_code none;
        for (const auto& entry : std::filesystem::directory_iterator(part, none)) {
            const std::string name = entry.path().filename().string();
            ASSERT_TRUE(std::filesystem::exists(std::filesystem::path(whole) / name)) << name;
            EXPECT_TRUE(readFile(entry.path()) == readFile(std::filesystem::path(whole) / name))
                << name;
        }
        std::filesystem::remove_all(part);
    }
}

} // namespace
} // namespace dirt::test
