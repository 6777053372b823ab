// No power of two below 2^-10 stands in the program's code without a name in
// shaders/shared/margins.h or a reason beside it: a comment on its line or the three lines before.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <vector>

namespace dirt::test {
namespace {

std::vector<std::string> linesOf(const std::filesystem::path& file) {
    std::ifstream stream(file);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

/// Lines with a bare power, as `file:line: text`.
void findBare(const std::filesystem::path& file, std::vector<std::string>& bare) {
    static const std::regex power(
        "0x1(\\.[0-9a-f]*)?p-(1[1-9]|[2-9][0-9]|[0-9]{3})|[^0-9]1\\.0 / [0-9]{5}");
    const std::vector<std::string> lines = linesOf(file);
    for (size_t i = 0; i < lines.size(); ++i) {
        const std::string code = lines[i].substr(0, lines[i].find("//"));
        if (code.find("p-") == code.npos && code.find("1.0 / ") == code.npos) continue;
        if (!std::regex_search(code, power)) continue;
        bool reason = false;
        for (size_t k = i < 3 ? 0 : i - 3; k <= i; ++k)
            reason = reason || lines[k].find("//") != std::string::npos;
        if (!reason) bare.push_back(file.string() + ":" + std::to_string(i + 1) + ":" + lines[i]);
    }
}

TEST(BarePowers, HaveNamesOrReasons) {
    const std::filesystem::path root(DIRT_SOURCE_DIR);
    std::vector<std::string> bare;
    int files = 0;
    for (const char* folder :
         {"core", "backend_cpu", "backend_gl", "backend_embree", "shaders", "app", "bench"})
        for (const auto& entry : std::filesystem::recursive_directory_iterator(root / folder)) {
            if (!entry.is_regular_file() || entry.path().filename() == "margins.h") continue;
            findBare(entry.path(), bare);
            ++files;
        }
    for (const std::string& line : bare) ADD_FAILURE() << line;
    EXPECT_GT(files, 200);
}

} // namespace
} // namespace dirt::test
