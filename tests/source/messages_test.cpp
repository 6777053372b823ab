// What the program says goes through app/cli/log.h, so that it is in the log, too. Tables may go to
// standard error, and progress does.

#include "tests/source/sources.h"

#include <regex>
#include <set>

#include <gtest/gtest.h>

namespace dirt {
namespace {

TEST(Messages, GoThroughTheLog) {
    static const std::regex kDirect(
        "\\b(?:f(?:printf|puts|putc|write)\\([^;]*\\bstderr\\b|perror\\(|cerr\\b)");
    const std::set<std::string> others{"app/cli/log.cpp", "app/cli/progress_bar.cpp",
                                       "app/cli/bench_tradeoff.cpp"};
    std::set<std::string> found;
    for (const std::string& file : test::sourceFiles({".cpp", ".h"}))
        if (!file.starts_with("tests/") && std::regex_search(test::sourceText(file), kDirect))
            found.insert(file);
    EXPECT_EQ(found, others);
}

} // namespace
} // namespace dirt
