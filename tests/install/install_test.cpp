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

TEST(Install, TheExampleBuildsAgainstIt) {
    const TemporaryFolder folder;
    const std::string prefix = folder / "prefix", build = folder / "build";
    const std::string example = std::string(DIRT_SOURCE_DIR) + "/examples/unit_test";
    ASSERT_NO_FATAL_FAILURE(
        run({"--install", DIRT_BINARY_DIR, "--prefix", prefix, "--component", "development"}));
    // Copied, so that nothing beside it can be found by accident.
    std::filesystem::copy(example, folder.path() / "example");
    ASSERT_NO_FATAL_FAILURE(
        run({"-S", folder / "example", "-B", build, "-G", DIRT_GENERATOR,
             "-DCMAKE_PREFIX_PATH=" + prefix, "-DCMAKE_CXX_COMPILER=" DIRT_CXX_COMPILER,
             "-DCMAKE_CXX_FLAGS=" DIRT_CXX_FLAGS}));
    ASSERT_NO_FATAL_FAILURE(run({"--build", build}));
    const Outcome tests = start(build + "/grid_test", {});
    EXPECT_EQ(tests.status, 0) << tests.out << tests.err;
    EXPECT_NE(tests.out.find("[  PASSED  ]"), std::string::npos) << tests.out;
#ifdef DIRT_HAVE_GL
    const Outcome glTests = start(build + "/gl_test", {});
    EXPECT_EQ(glTests.status, 0) << glTests.out << glTests.err;
#endif
}

} // namespace
} // namespace dirt::test
