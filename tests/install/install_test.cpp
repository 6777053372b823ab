// What `cmake --install` puts elsewhere is enough to build and run a project of one's own: the
// example of docs/unit-testing.md, with find_package(dirt).

#include "tests/cli/program.h"

#include <gtest/gtest.h>

namespace dirt::test {
namespace {

void run(const std::vector<std::string>& arguments) {
    const Outcome outcome = start(DIRT_CMAKE, arguments);
    ASSERT_EQ(outcome.status, 0) << outcome.out << outcome.err;
}

/// An installation, and an engine beside it that has folders and headers of the same names.
class Install : public testing::Test {
protected:
    void SetUp() override {
        for (const char* component : {"program", "development"})
            run({"--install", DIRT_BINARY_DIR, "--prefix", prefix_, "--component", component});
        for (const char* header : {"core/grid/grid.h", "core/base/error.h", "core/scene/scene.h"}) {
            const auto path = folder_.path() / "engine" / header;
            std::filesystem::create_directories(path.parent_path());
            folder_.write("engine/" + std::string(header), "#error \"the engine's own\"\n");
        }
        // Copied, so that nothing beside it can be found by accident.
        std::filesystem::copy(std::string(DIRT_SOURCE_DIR) + "/examples/unit_test",
                              folder_.path() / "example");
    }

    TemporaryFolder folder_;
    const std::string prefix_ = folder_ / "prefix", build_ = folder_ / "build";
    const std::string flags_ = std::string(DIRT_CXX_FLAGS) + " -I" + (folder_ / "engine");
};

TEST_F(Install, TheExampleBuildsAgainstIt) {
    ASSERT_NO_FATAL_FAILURE(
        run({"-S", folder_ / "example", "-B", build_, "-G", DIRT_GENERATOR,
             "-DCMAKE_PREFIX_PATH=" + prefix_, "-DCMAKE_CXX_COMPILER=" DIRT_CXX_COMPILER,
             "-DCMAKE_CXX_FLAGS=" + flags_}));
    ASSERT_NO_FATAL_FAILURE(run({"--build", build_}));
    const Outcome tests = start(build_ + "/grid_test", {});
    EXPECT_EQ(tests.status, 0) << tests.out << tests.err;
    EXPECT_NE(tests.out.find("[  PASSED  ]"), std::string::npos) << tests.out;
#ifdef DIRT_HAVE_GL
    const Outcome glTests = start(build_ + "/gl_test", {});
    EXPECT_EQ(glTests.status, 0) << glTests.out << glTests.err;
#endif
}

TEST_F(Install, PkgConfigIsEnough) {
    const std::string program = folder_ / "grid_test";
    const Outcome compiled =
        start("/bin/sh",
              {"-c", "PKG_CONFIG_PATH=$(dirname $(find '" + prefix_ +
                         "' -name dirt.pc)) && export PKG_CONFIG_PATH && " DIRT_CXX_COMPILER
                         " -std=c++20 " +
                         flags_ + " '" + (folder_ / "example/grid_test.cpp") + "' -o '" + program +
                         "' $(pkg-config --cflags --libs dirt) -lgtest -lgtest_main"});
    ASSERT_EQ(compiled.status, 0) << compiled.err;
    const Outcome tests = start(program, {});
    EXPECT_EQ(tests.status, 0) << tests.out << tests.err;
}

/// What is installed renders what is installed with it, once its geometry is made.
TEST_F(Install, TheProgramRendersItsScenes) {
    const std::string picture = folder_ / "picture.png";
    const Outcome made = start(prefix_ + "/bin/dirt", {"generate", "cornell", "-o",
                                                       prefix_ + "/share/dirt/scenes/generated"});
    EXPECT_EQ(made.status, 0) << made.err;
    const Outcome rendered =
        start(prefix_ + "/bin/dirt", {"render", prefix_ + "/share/dirt/scenes/cornell.scene",
                                      "--size", "16x16", "--spp", "1", "-o", picture});
    EXPECT_EQ(rendered.status, 0) << rendered.err;
    EXPECT_TRUE(std::filesystem::exists(picture));
}

} // namespace
} // namespace dirt::test
