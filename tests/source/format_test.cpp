// The code is formatted as clang-format 14 formats it.

#include "tests/source/sources.h"

#include <gtest/gtest.h>

namespace dirt {
namespace {

TEST(Format, IsThatOfClangFormat) {
    if (test::outputOf("clang-format --version 2>/dev/null").find("version 14.") ==
        std::string::npos)
        GTEST_SKIP() << "no clang-format 14";
    std::string command = "cd '" DIRT_SOURCE_DIR "' && clang-format --dry-run 2>&1";
    for (const std::string& file : test::sourceFiles({".h", ".cpp"})) command += " " + file;
    EXPECT_EQ(test::outputOf(command).substr(0, 2000), "");
}

} // namespace
} // namespace dirt
