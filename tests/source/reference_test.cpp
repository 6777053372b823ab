// The reference of the public headers is made without a warning.

#include "tests/source/sources.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

namespace dirt {
namespace {

TEST(Reference, DoxygenHasNothingToWarnOf) {
    if (test::outputOf("doxygen --version 2>/dev/null").empty()) GTEST_SKIP() << "no Doxygen";
    const test::TemporaryFolder folder;
    const std::string command = "cd '" DIRT_SOURCE_DIR "' && (cat docs/Doxyfile; "
                                "echo OUTPUT_DIRECTORY=" +
                                folder.path().string() + ") | doxygen - 2>&1";
    EXPECT_EQ(test::outputOf(command).substr(0, 2000), "");
    EXPECT_TRUE(std::filesystem::exists(folder / "html/index.html"));
}

} // namespace
} // namespace dirt
