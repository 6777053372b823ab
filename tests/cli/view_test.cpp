// `dirt view` where no window can be opened.

#include "tests/cli/program.h"

#include <cstdlib>

#include <gtest/gtest.h>

namespace dirt::test {
namespace {

TEST(View, WithoutADisplayEndsWithOneLineAndStatus3) {
    unsetenv("DISPLAY");
    unsetenv("WAYLAND_DISPLAY");
    const TemporaryFolder folder;
    const Outcome run = dirt({"view", folder.write("a.obj", kTriangleObj)});
    EXPECT_EQ(run.status, 3);
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_TRUE(run.err.starts_with("dirt: no window: ") || run.err.starts_with("dirt: view: "))
        << run.err;
}

} // namespace
} // namespace dirt::test
