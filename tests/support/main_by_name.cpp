// main() of a program with the tests of several files: called by the name of one of them, as
// trace_intersect_test for trace/intersect_test.cpp, it runs the tests of that file alone.

#include <algorithm>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

namespace {

/// As the programs are called.
std::string nameOf(const std::filesystem::path& source) {
    return source.parent_path().filename().string() + "_" + source.stem().string();
}

/// To what the user's filter leaves out, adds the tests of other files than that called \p name.
void leaveOutOthers(const std::string& name) {
    const testing::UnitTest& all = *testing::UnitTest::GetInstance();
    std::string others;
    bool named = false;
    for (int s = 0; s < all.total_test_suite_count(); ++s) {
        const testing::TestSuite& suite = *all.GetTestSuite(s);
        for (int t = 0; t < suite.total_test_count(); ++t) {
            const testing::TestInfo& test = *suite.GetTestInfo(t);
            if (nameOf(test.file()) == name)
                named = true;
            else
                others += std::string(":") + suite.name() + "." + test.name();
        }
    }
    if (!named || others.empty()) return;
    std::string filter = testing::GTEST_FLAG(filter);
    if (filter.find('-') == std::string::npos) filter += "-", others.erase(0, 1);
    testing::GTEST_FLAG(filter) = filter + others;
}

} // namespace

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    leaveOutOthers(std::filesystem::path(argv[0]).filename().string());
    return RUN_ALL_TESTS();
}
