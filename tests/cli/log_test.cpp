// --log FILE: every command takes it, and what it says is in the file, with time and level, quiet
// or not, however it ends.

#include "app/cli/log.h"
#include "core/io/image.h"
#include "tests/cli/log_fixture.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <limits>
#include <thread>

#include <gtest/gtest.h>

namespace dirt::test {
namespace {

namespace fs = std::filesystem;

/// With a size that is worth a cache.
std::string largeObj(std::string begin) {
    begin += kTriangleObj;
    while (begin.size() < (1 << 16)) begin += "# worth a cache\n";
    return begin;
}

/// Of each command a line that fails after its options were read.
TEST_F(LogTest, EveryCommandTakesIt) {
    const std::string none = folder_ / "none.obj", png = folder_ / "none.png";
    const std::vector<Lines> commands{{"render", none},
                                      {"verify", none},
                                      {"check", none, "--backends", "cpu,cpu", "--quiet"},
                                      {"compare", png, png},
                                      {"bench", "frame", none},
                                      {"bench", "tradeoff", none, "-o", folder_ / "out"},
                                      {"bench", "scaling", "-o", folder_ / "log/out"},
                                      {"info", none},
                                      {"dump", none, "-o", folder_ / "out"},
                                      {"explain", none, "--pixel", "0,0"},
                                      {"preview", none, "-o", folder_ / "out.png"},
                                      {"view", folder_ / "a.obj"},
                                      {"replay", folder_ / "out"},
                                      {"generate", "nothing", "-o", folder_ / "out"}};
    for (const Lines& command : commands) {
        SCOPED_TRACE(command[0] + " " + command[1]);
        const Outcome ran = run(command);
        EXPECT_TRUE(ran.status == 2 || ran.status == 3) << ran.status << ran.err;
        Lines expected = linesOf(ran.err);
        ASSERT_EQ(expected.size(), 1u) << ran.err;
        expected[0].replace(0, std::string("dirt:").size(), "error:");
        const Lines logged = messages();
        const bool isQuiet = command.back() == "--quiet"; // and its warning is not in err
        EXPECT_EQ(Lines(logged.begin() + isQuiet, logged.end()), expected);
    }
}

TEST_F(LogTest, BeginsWithVersionAndCommandLine) {
    const std::string odd = folder_.write("a b.obj", kTriangleObj);
    EXPECT_EQ(run({"info", odd, "--size", "8x8"}).status, 0);
    const std::string text = readFile(log_), first = text.substr(0, text.find('\n'));
    EXPECT_EQ(first.substr(25),
              "note: " + version_ + ": dirt info '" + odd + "' --size 8x8 --log " + log_);
}

/// All that standard error has, quiet or not.
TEST_F(LogTest, HasWhatIsSaid) {
    Image image{2, 1, {glm::vec3(1.0f), glm::vec3(2.0f)}};
    writeExr(folder_ / "a.exr", image, {});
    const std::string scene = folder_ / "a.scene", small = "16x8";
    const std::string dump = folder_ / "dump";
    const std::vector<std::pair<Lines, Lines>> runs{
        {{"render", scene, "--size", small, "--spp", "1", "-o", folder_ / "a.png", "--frames",
          "0:1"},
         {"warning: " + (folder_ / "a.obj") + ":1: material file 'none.mtl' not found",
          "note: ignored: ", "warning: --frames: the scene does not move",
          "note: wrote " + (folder_ / "a.0000.png"), "note: wrote " + (folder_ / "a.0001.png")}},
        {{"render", scene, "--size", small, "--spp", "1", "-o", folder_ / "a.png", "--frame", "1",
          "--visibility", "traced"},
         {"warning: --frame: the scene does not move",
          "warning: --visibility: the scene has no light"}},
        {{"check", scene, "--size", "8x8", "--backends", "cpu,cpu"},
         {"warning: --backends cpu,cpu: a backend is compared with itself"}},
        {{"dump", scene, "--size", small, "-o", dump, "--buffers", "depth,shadowmap"},
         {"warning: --buffers shadowmap: this frame has none",
          "note: wrote " + dump + "/depth.exr"}},
        {{"dump", scene, "--size", small, "-o", folder_ / "pixel.json", "--pixel", "3,3"},
         {"note: wrote " + (folder_ / "pixel.json")}},
        {{"preview", scene, "--size", small, "-o", folder_ / "b.png", "--show", "near"},
         {"note: wrote " + (folder_ / "b.png") + ": near, "}},
    };
    for (const auto& [command, expected] : runs) {
        const Outcome loud = run(command);
        ASSERT_EQ(loud.status, 0) << loud.err;
        const Lines logged = messages();
        for (const std::string& line : expected)
            EXPECT_TRUE(std::any_of(logged.begin(), logged.end(), [&](const std::string& one) {
                return one.starts_with(line);
            })) << line;
        // What standard error has is there in its order.
        const Lines said = asLogged(loud.err);
        EXPECT_GE(said.size(), expected.size());
        auto at = logged.begin();
        for (const std::string& line : said) {
            at = std::find(at, logged.end(), line);
            ASSERT_NE(at, logged.end()) << line;
            ++at;
        }
        const Outcome quiet = run(command, {"--quiet"});
        EXPECT_EQ(quiet.err, "");
        EXPECT_EQ(messages(), logged);
    }
}

/// Commands that read no scene, and files that standard error does not name.
TEST_F(LogTest, HasFilesAndWhatIsLeftOut) {
    Image image{2, 1, {glm::vec3(1.0f), glm::vec3(2.0f)}};
    writeExr(folder_ / "a.exr", image, {});
    image.pixels[1].x = std::numeric_limits<float>::quiet_NaN();
    writeExr(folder_ / "b.exr", image, {});
    const std::string diff = folder_ / "diff.png";
    EXPECT_EQ(run({"compare", folder_ / "a.exr", folder_ / "b.exr", "--diff", diff}).status, 1);
    EXPECT_EQ(messages(), (Lines{"note: wrote " + diff,
                                 "error: 1 of 2 pixels are NaN or infinite and left out: "
                                 "0 in " +
                                     (folder_ / "a.exr") + ", 1 in " + (folder_ / "b.exr")}));
    const Outcome made = run({"generate", "cornell", "-o", folder_ / "made"});
    ASSERT_EQ(made.status, 0) << made.err;
    EXPECT_EQ(messages(), asLogged(made.out));
    const std::string stats = folder_ / "stats.json", picture = folder_ / "a.png";
    EXPECT_EQ(run({"render", folder_.write("plain.obj", kTriangleObj), "--size", "8x8", "--spp",
                   "1", "-o", picture, "--stats", stats})
                  .status,
              0);
    EXPECT_EQ(messages(), (Lines{"note: wrote " + picture, "note: wrote " + stats}));
}

TEST_F(LogTest, HasWhatEndsTheCommand) {
    // Wrong options, before and behind the log's.
    for (const Lines& wrong :
         {Lines{"--spp", "0"}, {"--bogus"}, {"--tile", "x"}, {"--frame", "-1"}}) {
        Lines before{"render", folder_ / "a.obj"};
        before.insert(before.end(), wrong.begin(), wrong.end());
        for (const Outcome& ran : {run(before), run({"render", folder_ / "a.obj"}, wrong)}) {
            EXPECT_EQ(ran.status, 2);
            EXPECT_EQ(messages(), (Lines{"error: " + ran.err.substr(6, ran.err.size() - 7)}));
        }
    }
    // What was said before the end, too.
    const Outcome strict =
        run({"render", folder_ / "a.scene", "--quiet", "-o", folder_ / "x/a.png"});
    EXPECT_EQ(strict.status, 2);
    EXPECT_EQ(messages(), (Lines{"error: " + strict.err.substr(6, strict.err.size() - 7)}));
    const Outcome late = run({"render", folder_ / "a.scene", "--quiet", "--spp", "1000000", "-o",
                              folder_ / "a.png", "--aov", "depth"});
    EXPECT_EQ(late.status, 2);
    ASSERT_GE(messages().size(), 2u);
    EXPECT_TRUE(messages().front().starts_with("warning: "));
    EXPECT_EQ(messages().back(), "error: " + late.err.substr(6, late.err.size() - 7));
    // Of standard output, which fails last of all.
    const Outcome full = startDirt({"info", folder_ / "a.obj", "--log", log_}, [] {
        if (!std::freopen("/dev/full", "w", stdout)) _exit(126);
    });
    EXPECT_EQ(full.status, 2);
    EXPECT_TRUE(messages().back().starts_with("error: standard output: cannot write: "));
}

/// After whatever is said first, which ends up in the file at once.
TEST_F(LogTest, HasWhatASignalLeaves) {
    const auto has = [&](const std::string& text) {
        return fs::exists(log_) && readFile(log_).find(text) != std::string::npos;
    };
    const Lines render{"render", folder_ / "a.scene", "--quiet", "--size",          "16x8",
                       "--spp",  "1000000",           "-o",      folder_ / "a.png", "--log",
                       log_};
    for (const int signal : {SIGINT, SIGKILL}) {
        bool done = false;
        for (int wait = 100; wait < 100'000 && !done; wait *= 2) {
            fs::remove(log_);
            Process process(DIRT_PROGRAM, render, [signal] { ::signal(signal, SIG_DFL); });
            for (int i = 0; i < 6000 && !has("none.mtl"); ++i)
                std::this_thread::sleep_for(std::chrono::milliseconds(10));
            std::this_thread::sleep_for(std::chrono::milliseconds(wait));
            kill(process.id(), signal);
            const Outcome ran = process.wait();
            EXPECT_EQ(ran.status, 128 + signal) << ran.err;
            EXPECT_TRUE(has("warning: ")) << "the file was not there before the end";
            done = signal == SIGKILL || has("error: stopped after "); // or it had not begun
        }
        EXPECT_TRUE(done);
    }
}

TEST_F(LogTest, CachesAreSaidWhereTheyAreLeft) {
    const std::string obj = folder_.write("large.obj", largeObj("")), cache = obj + ".sbin";
    const std::string text =
        "wrote " + cache + ", for faster loading from now on (--no-cache leaves none)";
    const std::string picture = folder_ / "a.png";
    const Lines render{"render", obj, "--size", "8x8", "--spp", "1", "--json", "-o", picture};
    const Outcome first = run(render);
    EXPECT_EQ(first.err, "dirt: " + text + "\n" + picture + "\n");
    EXPECT_EQ(first.out.front(), '{');
    EXPECT_EQ(messages().front(), "note: " + text);
    EXPECT_EQ(run(render).err, picture + "\n");
    EXPECT_EQ(messages(), (Lines{"note: wrote " + picture}));
    fs::remove(cache);
    EXPECT_EQ(run(render, {"--no-cache"}).err, picture + "\n");
    // info prints its report and no more.
    for (const Lines& quiet :
         {Lines{"check", obj, "--backends", "cpu,cpu", "--size", "8x8", "--quiet"},
          {"info", obj}}) {
        fs::remove(cache);
        EXPECT_EQ(run(quiet).err, "");
        EXPECT_EQ(messages().back(), "note: " + text);
    }
    // One line for all of a scene.
    std::string scene = "<world>";
    for (int i = 0; i < 7; ++i) {
        const std::string name = std::to_string(i) + ".obj";
        folder_.write(name, largeObj(""));
        scene += "<object file='" + name + "'/>";
    }
    const Outcome many = run({"explain", folder_.write("many.scene", scene + "</world>"), "--size",
                              "8x8", "--pixel", "0,0"});
    EXPECT_NE(many.err.find("4.obj.sbin and 2 more, for faster loading"), many.err.npos)
        << many.err;
    EXPECT_EQ(messages().size(), 1u);
}

/// As the viewer's threads do.
TEST_F(LogTest, LinesOfThreadsDoNotMix) {
    const char* argv[] = {"dirt", "test"};
    CapturedStream err(stderr);
    {
        Log log(2, argv);
        log.open(log_);
        std::vector<std::thread> threads;
        for (int thread = 0; thread < 4; ++thread)
            threads.emplace_back([thread] {
                for (int i = 0; i < 500; ++i)
                    sayWarning("of thread " + std::to_string(thread) + std::string(100, '.'),
                               false);
            });
        for (std::thread& thread : threads) thread.join();
        sayPlain("two\nlines");
    }
    sayError("after its end");
    Lines logged = messages();
    EXPECT_EQ(logged.size(), 2002u);
    const Lines said = linesOf(err.text());
    ASSERT_EQ(said.size(), 2003u);
    EXPECT_EQ(said[2000], "two");
    EXPECT_EQ(said[2002], "dirt: after its end");
    for (size_t i = 0; i < 2000; ++i) EXPECT_EQ("dirt: " + logged[i], said[i]);
    EXPECT_EQ(Lines(logged.end() - 2, logged.end()), (Lines{"note: two", "note: lines"}));
}

} // namespace
} // namespace dirt::test
