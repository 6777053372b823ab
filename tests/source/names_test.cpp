// Files of a folder may be compiled together (cmake/unity.cmake), where a name in one file's
// unnamed namespace hides the same name of a header from those that follow it: without a word,
// where both are numbers. So none has a name that a neighbour takes from a header.

#include "tests/source/sources.h"

#include <filesystem>
#include <map>
#include <regex>
#include <set>

#include <gtest/gtest.h>

namespace dirt {
namespace {

using Names = std::set<std::string>;

/// The names that \p text declares at the beginnings of lines, as clang-format leaves namespaces'
/// members, and nothing else but the ends of members that take several lines.
Names declaredIn(const std::string& text) {
    static const std::regex kType("^(?:class|struct|enum class|enum|using|union) (\\w+)");
    static const std::regex kOther("^(?:[\\w:<>,&*\\[\\] ]+?[ &*])?(\\w+) ?[(={;\\[].*");
    static const std::regex kFurther(", (k[A-Z]\\w*) = ");
    static const Names kNoNames{"namespace", "static_assert", "template", "return", "operator"};
    Names names;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (line.empty() || !(std::isalpha((unsigned char) line[0]) || line[0] == '_')) continue;
        // Which names what has that name already.
        if (line.starts_with("using ") && line.find('=') == std::string::npos) continue;
        std::smatch match;
        if (!std::regex_search(line, match, kType) && !std::regex_match(line, match, kOther))
            continue;
        if (!kNoNames.contains(match[1])) names.insert(match[1]);
        for (auto at = std::sregex_iterator(line.begin(), line.end(), kFurther);
             at != std::sregex_iterator(); ++at)
            names.insert((*at)[1]);
    }
    return names;
}

/// What stands in a file's unnamed namespaces.
std::string unnamedPart(const std::string& file) {
    std::istringstream lines(test::sourceText(file));
    std::string part;
    bool inside = false;
    for (std::string line; std::getline(lines, line);) {
        if (line == "namespace {")
            inside = true;
        else if (line == "} // namespace")
            inside = false;
        else if (inside)
            part += line + "\n";
    }
    return part;
}

/// Headers, by what includes them, itself or through others.
class Headers {
public:
    const Names& of(const std::string& file) {
        const auto known = reached_.find(file);
        if (known != reached_.end()) return known->second;
        Names all;
        if (std::filesystem::exists(std::filesystem::path(DIRT_SOURCE_DIR) / file))
            for (const std::string& name : test::includesOf(file)) {
                all.insert(name);
                const Names& further = of(name);
                all.insert(further.begin(), further.end());
            }
        return reached_[file] = all;
    }

private:
    std::map<std::string, Names> reached_;
};

/// Whether \p text has \p name as a word.
bool mentions(const std::string& text, const std::string& name) {
    const auto isWord = [](char c) { return std::isalnum((unsigned char) c) || c == '_'; };
    for (size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1))
        if ((at == 0 || !isWord(text[at - 1])) && !isWord(text[at + name.size()])) return true;
    return false;
}

std::string folderOf(const std::string& file) {
    return file.substr(0, file.rfind('/'));
}

TEST(Names, NoFileHidesWhatItsNeighbourIncludes) {
    std::map<std::string, Names> declaring; // headers, by name
    for (const std::string& header : test::sourceFiles({".h"}))
        for (const std::string& name : declaredIn(test::sourceText(header)))
            declaring[name].insert(header);
    EXPECT_TRUE(declaring["kTrianglesPerPiece"].contains("backend_cpu/build/rasterizer.h"));

    std::map<std::string, std::vector<std::string>> folders;
    for (const std::string& file : test::sourceFiles({".cpp"}))
        if (!file.starts_with("examples/")) folders[folderOf(file)].push_back(file);
    Headers headers;
    size_t names = 0;
    for (const auto& [folder, files] : folders)
        for (const std::string& file : files)
            for (const std::string& name : declaredIn(unnamedPart(file))) {
                ++names;
                const auto found = declaring.find(name);
                if (found == declaring.end()) continue;
                for (const std::string& neighbour : files)
                    for (const std::string& header : found->second)
                        EXPECT_FALSE(neighbour != file && headers.of(neighbour).contains(header) &&
                                     mentions(test::sourceText(neighbour), name))
                            << name << " of " << file << " hides that of " << header << " from "
                            << neighbour;
            }
    EXPECT_GT(names, 1000u);
}

} // namespace
} // namespace dirt
