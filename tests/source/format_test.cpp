// The code is formatted as clang-format 14 formats it.

#include "tests/source/sources.h"

#include <cstdio>
#include <cstdlib>

#include <gtest/gtest.h>

namespace dirt {
namespace {

std::string outputOf(const std::string& command) {
    std::string output;
    FILE* pipe = popen(command.c_str(), "r");
    if (!pipe) return output;
    char line[4096];
    while (std::fgets(line, sizeof line, pipe)) output += line;
    pclose(pipe);
    return output;
}

TEST(Format, IsThatOfClangFormat) {
    if (outputOf("clang-format --version 2>/dev/null").find("version 14.") == std::string::npos)
        GTEST_SKIP() << "no clang-format 14";
    std::string command = "cd '" DIRT_SOURCE_DIR "' && clang-format --dry-run 2>&1";
    for (const std::string& file : test::sourceFiles({".h", ".cpp"})) command += " " + file;
    EXPECT_EQ(outputOf(command).substr(0, 2000), "");
}

} // namespace
} // namespace dirt
