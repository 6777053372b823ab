// The examples of docs/unit-testing.md: compiled and run here, and equal to what the page shows.

#include "examples/unit_test/grid_test.cpp"

#include <fstream>
#include <map>
#include <sstream>
#include <string>

namespace dirt::test {
namespace {

std::string readText(const std::string& file) {
    std::ostringstream text;
    text << std::ifstream(std::string(DIRT_SOURCE_DIR) + "/" + file).rdbuf();
    return text.str();
}

/// Text between lines "//! NAME" and "//! end", by name.
std::map<std::string, std::string> markedParts(const std::string& source) {
    std::map<std::string, std::string> parts;
    std::istringstream lines(source);
    std::string line, name;
    while (std::getline(lines, line)) {
        if (line.rfind("//! ", 0) == 0)
            name = line == "//! end" ? "" : line.substr(4);
        else if (!name.empty())
            parts[name] += line + "\n";
    }
    return parts;
}

/// Code blocks below lines "<!-- NAME -->", by name.
std::map<std::string, std::string> shownParts(const std::string& page) {
    std::map<std::string, std::string> parts;
    std::istringstream lines(page);
    std::string line, name;
    bool inside = false;
    while (std::getline(lines, line)) {
        if (line.rfind("<!-- ", 0) == 0)
            name = line.substr(5, line.find(" -->") - 5);
        else if (line.rfind("```", 0) == 0 && !name.empty()) {
            if (inside)
                name.clear();
            else
                parts[name];
            inside = !inside;
        } else if (inside)
            parts[name] += line + "\n";
    }
    return parts;
}

TEST(UnitTestingPage, ShowsTheExamplesAsTheyAre) {
    auto expected = markedParts(readText("examples/unit_test/grid_test.cpp"));
    EXPECT_GE(expected.size(), 9u);
    expected["cmake"] = readText("examples/unit_test/CMakeLists.txt");
    const auto shown = shownParts(readText("docs/unit-testing.md"));
    for (const auto& [name, text] : expected) {
        ASSERT_TRUE(shown.count(name)) << "docs/unit-testing.md does not show " << name;
        EXPECT_EQ(shown.at(name), text) << name;
    }
    EXPECT_EQ(shown.size(), expected.size());
}

} // namespace
} // namespace dirt::test
