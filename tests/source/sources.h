#pragma once

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace dirt::test {

/// The project's folders that are kept in order; others (build folders, copies) are none of its
/// matter.
inline const std::vector<std::string> kSourceFolders{
    "app",  "backend_cpu", "backend_embree", "backend_gl", "bench", "core",
    "docs", "examples",    "scenes",         "shaders",    "tests"};

/// Files below the source folders with one of \p extensions, relative to the root, sorted.
inline std::vector<std::string> sourceFiles(const std::vector<std::string>& extensions) {
    namespace fs = std::filesystem;
    const fs::path root = DIRT_SOURCE_DIR;
    std::vector<std::string> files;
    for (const std::string& folder : kSourceFolders)
        for (const auto& entry : fs::recursive_directory_iterator(root / folder))
            if (std::count(extensions.begin(), extensions.end(), entry.path().extension()) > 0)
                files.push_back(fs::relative(entry.path(), root).generic_string());
    std::sort(files.begin(), files.end());
    return files;
}

inline std::string sourceText(const std::string& file) {
    std::ifstream in(std::filesystem::path(DIRT_SOURCE_DIR) / file);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

/// What a file of C++ or GLSL includes in quotes.
inline std::vector<std::string> includesOf(const std::string& file) {
    static const std::regex kInclude("(?:^|\n)[ \t]*#include \"([^\"\n]+)\"");
    const std::string text = sourceText(file);
    std::vector<std::string> names;
    for (auto at = std::sregex_iterator(text.begin(), text.end(), kInclude);
         at != std::sregex_iterator(); ++at)
        names.push_back((*at)[1]);
    return names;
}

/// What a shell command prints on standard output.
inline std::string outputOf(const std::string& command) {
    std::string output;
    FILE* pipe = popen(command.c_str(), "r");
    if (!pipe) return output;
    char line[4096];
    while (std::fgets(line, sizeof line, pipe)) output += line;
    pclose(pipe);
    return output;
}

} // namespace dirt::test
