#pragma once

#include <fstream>
#include <map>
#include <sstream>
#include <string>

/// What documents show of the examples, to be compared with what is compiled.
namespace dirt::test {

/// A file of the source tree.
inline std::string sourceFile(const std::string& file) {
    std::ostringstream text;
    text << std::ifstream(std::string(DIRT_SOURCE_DIR) + "/" + file).rdbuf();
    return text.str();
}

/// Text between lines "//! NAME" and "//! end", by name.
inline std::map<std::string, std::string> markedParts(const std::string& source) {
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
inline std::map<std::string, std::string> shownParts(const std::string& page) {
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

} // namespace dirt::test
