// The examples of docs/unit-testing.md: compiled and run here, and equal to what the page shows.

#include "examples/unit_test/grid_test.cpp"
#include "tests/support/shown_parts.h"

namespace dirt::test {
namespace {

TEST(UnitTestingPage, ShowsTheExamplesAsTheyAre) {
    auto expected = markedParts(sourceFile("examples/unit_test/grid_test.cpp"));
    EXPECT_GE(expected.size(), 10u);
    expected.merge(markedParts(sourceFile("examples/unit_test/gl_test.cpp")));
    expected["cmake"] = sourceFile("examples/unit_test/CMakeLists.txt");
    const auto shown = shownParts(sourceFile("docs/unit-testing.md"));
    for (const auto& [name, text] : expected) {
        ASSERT_TRUE(shown.count(name)) << "docs/unit-testing.md does not show " << name;
        EXPECT_EQ(shown.at(name), text) << name;
    }
    EXPECT_EQ(shown.size(), expected.size());
}

} // namespace
} // namespace dirt::test
