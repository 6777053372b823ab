// Files that the documents name are there.

#include "tests/source/sources.h"

#include <regex>

#include <gtest/gtest.h>

namespace dirt {
namespace {

namespace fs = std::filesystem;

TEST(Documents, NameFilesThatExist) {
    // `folder/file.ext`, or `folder/file` of several files, in backquotes.
    static const std::regex kPath(
        "`((?:app|backend_[a-z]+|bench|core|scenes|shaders|tests)/[A-Za-z0-9_./-]*)`");
    const fs::path root = DIRT_SOURCE_DIR;
    std::vector<std::string> documents = test::sourceFiles({".md"});
    documents.push_back("README.md");
    documents.push_back("CONTRIBUTING.md");
    size_t named = 0;
    for (const std::string& document : documents) {
        const std::string text = test::sourceText(document);
        for (auto at = std::sregex_iterator(text.begin(), text.end(), kPath);
             at != std::sregex_iterator(); ++at, ++named) {
            const std::string path = (*at)[1];
            if (path.starts_with("scenes/generated")) continue; // made by `dirt generate`
            EXPECT_TRUE(fs::exists(root / path) || fs::exists(root / (path + ".h")) ||
                        fs::exists(root / (path + ".cpp")))
                << document << " names " << path;
        }
    }
    EXPECT_GT(named, 100u);
}

} // namespace
} // namespace dirt
