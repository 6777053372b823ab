#include "core/io/find_file.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <string>

namespace dirt {
namespace {

class FindFile : public testing::Test {
protected:
    /// Where \p name is found, relative to the folder; empty if it is not.
    std::string find(const std::string& name) {
        const auto found = findFile(folder_.path(), name);
        return found ? found->lexically_relative(folder_.path()).string() : "";
    }
    test::TemporaryFolder folder_;
};

TEST_F(FindFile, FindsTheNameAsItIs) {
    folder_.write("Maps/a file.png", "");
    EXPECT_EQ(find("Maps/a file.png"), "Maps/a file.png");
    EXPECT_EQ(find("./Maps//../Maps/a file.png"), "Maps/a file.png");
    EXPECT_EQ(findFile("/nowhere", (folder_.path() / "Maps/a file.png").string()),
              folder_.path() / "Maps/a file.png");
}

TEST_F(FindFile, TakesBackslashesAndAnyLetterCase) {
    folder_.write("Maps/Wood.PNG", "");
    EXPECT_EQ(find("maps\\wood.png"), "Maps/Wood.PNG");
    EXPECT_EQ(find(".\\MAPS\\WOOD.png"), "Maps/Wood.PNG");
}

TEST_F(FindFile, PrefersTheExactName) {
    folder_.write("A.png", "");
    folder_.write("a.png", "");
    EXPECT_EQ(find("a.png"), "a.png");
    EXPECT_EQ(find("A.png"), "A.png");
    EXPECT_EQ(find("a.PNG"), "A.png"); // the first in byte order
}

TEST_F(FindFile, FindsFilesOnly) {
    folder_.write("maps/a.png", "");
    for (const char* name :
         {"", "maps", "maps/", "none.png", "maps/a.png/b", "a.png", "maps/a.png/"})
        EXPECT_EQ(find(name), "") << name;
    EXPECT_EQ(find(std::string(100000, 'x')), "");
}

} // namespace
} // namespace dirt
