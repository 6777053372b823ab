// Threads that cannot be made: the program goes on with those there are, says so once, and gives
// the same picture.

#include "tests/cli/program.h"

#include <algorithm>
#include <cstdlib>

#include <gtest/gtest.h>

namespace dirt::test {
namespace {

class FewThreads : public testing::Test {
protected:
    void SetUp() override {
#ifndef DIRT_FEW_THREADS
        GTEST_SKIP() << "a sanitizer has to be the first library";
#else
        // Libraries make some before main(), without which no program starts.
        while (least_ < 64 && runWith(least_, {"--version"}).status != 0) ++least_;
        ASSERT_LT(least_, 64);
#endif
    }

    static Outcome runWith(int threads, const std::vector<std::string>& arguments) {
        return startDirt(arguments, [threads] {
#ifdef DIRT_FEW_THREADS
            setenv("LD_PRELOAD", DIRT_FEW_THREADS, 1);
#endif
            setenv("DIRT_TEST_THREADS", std::to_string(threads).c_str(), 1);
            alarm(60); // a hang
        });
    }

    /// The same with more and more threads besides those before main(). Status 3, with its line, is
    /// right where \p mayLack says so.
    void expectSame(const std::vector<std::string>& arguments, const std::string& file, int most,
                    bool mayLack = false) {
        ASSERT_EQ(startDirt(arguments).status, 0);
        const std::string whole = readFile(file);
        int done = 0;
        for (int threads = 0; threads <= most; ++threads) {
            SCOPED_TRACE(arguments[0] + " with " + std::to_string(threads));
            std::filesystem::remove(file);
            const Outcome run = runWith(least_ + threads, arguments);
            const auto lines = std::count(run.err.begin(), run.err.end(), '\n');
            if (mayLack && run.status == 3) {
                EXPECT_LE(lines, 2) << run.err;
                continue;
            }
            ++done;
            EXPECT_EQ(run.status, 0) << run.err;
            EXPECT_TRUE(readFile(file) == whole);
            EXPECT_LE(lines, 2) << run.err; // the picture's name, and at most one warning
            const bool few = run.err.find(" threads cannot be made") != std::string::npos;
            if (threads < 3) {
                EXPECT_EQ(few, run.err.find("warning") != std::string::npos) << run.err;
            }
        }
        EXPECT_GT(done, 0);
    }

    TemporaryFolder folder_;
    const std::string scene_ = litTriangle(folder_);
    int least_ = 0;
};

std::vector<std::string> render(const std::string& scene, const std::string& output,
                                const std::string& backend) {
    return {"render",    scene, "--size", "16x16", "--spp",     "1",
            "--threads", "4",   "-o",     output,  "--backend", backend};
}

TEST_F(FewThreads, RenderGoesOnWithThoseThereAre) {
    expectSame(render(scene_, folder_ / "a.exr", "cpu"), folder_ / "a.exr", 9);
    expectSame(render(scene_, folder_ / "a.png", "cpu"), folder_ / "a.png", 9);
    EXPECT_NE(runWith(least_, render(scene_, folder_ / "a.png", "cpu"))
                  .err.find("dirt: warning: 3 of 4 threads cannot be made: going on with 1\n"),
              std::string::npos);
}

#ifdef DIRT_HAVE_EMBREE
TEST_F(FewThreads, EmbreeTakesWhatItGets) {
    expectSame(render(scene_, folder_ / "a.exr", "embree"), folder_ / "a.exr", 12, true);
}
#endif

TEST_F(FewThreads, OpenGlTakesWhatItGets) {
    if (!std::getenv("DIRT_TEST_FULL")) GTEST_SKIP() << "takes minutes: in the long form";
    const auto arguments = render(scene_, folder_ / "a.exr", "gl");
    if (startDirt(arguments).status == 3) GTEST_SKIP() << "no OpenGL here";
    expectSame(arguments, folder_ / "a.exr", 4);
}

TEST_F(FewThreads, OtherCommandsToo) {
    expectSame({"generate", "cornell", "-o", folder_ / "c"}, folder_ / "c/cornell.obj", 4);
    const std::string a = folder_ / "a.exr", b = folder_ / "b.exr";
    ASSERT_EQ(startDirt(render(scene_, a, "cpu")).status, 0);
    ASSERT_EQ(startDirt(render(scene_, b, "cpu")).status, 0);
    for (int threads = 0; threads < 6; ++threads)
        EXPECT_EQ(runWith(least_ + threads, {"compare", a, b}).status, 0) << threads;
}

} // namespace
} // namespace dirt::test
