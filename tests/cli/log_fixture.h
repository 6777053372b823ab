#pragma once

#include "tests/cli/program.h"

#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace dirt::test {

using Lines = std::vector<std::string>;

inline Lines linesOf(const std::string& text) {
    Lines lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

/// A scene that lacks something, and what a log has of a run.
class LogTest : public testing::Test {
protected:
    LogTest() {
        unsetenv("DISPLAY");
        unsetenv("WAYLAND_DISPLAY");
        setenv("XDG_CACHE_HOME", (folder_ / "user").c_str(), 1);
        folder_.write("a.obj", std::string("mtllib none.mtl\nodd 1\n") + kTriangleObj);
        folder_.write("a.scene", "<world mood='bad'><object file='a.obj'/>"
                                 "<user position='0 0 0' lookat='0 0 -1'/></world>");
    }

    /// "LEVEL: TEXT" of each line but the first, all of which have the form that they should.
    Lines messages(const std::string& file) const {
        static const std::regex kForm(
            "\\d{4}-\\d\\d-\\d\\dT\\d\\d:\\d\\d:\\d\\d\\.\\d{3}Z ((error|warning|note): .*)");
        Lines all;
        for (const std::string& line : linesOf(readFile(file))) {
            std::smatch match;
            EXPECT_TRUE(std::regex_match(line, match, kForm)) << line;
            if (match.size() > 1) all.push_back(match[1]);
        }
        EXPECT_FALSE(all.empty());
        if (all.empty()) return all;
        EXPECT_TRUE(all.front().starts_with("note: " + version_ + ": ")) << all.front();
        all.erase(all.begin());
        return all;
    }
    Lines messages() const { return messages(log_); }

    Outcome run(Lines arguments, const Lines& more = {}) const {
        arguments.insert(arguments.end(), {"--log", log_});
        arguments.insert(arguments.end(), more.begin(), more.end());
        return dirt(arguments);
    }

    /// What standard error has, as the log has it.
    static Lines asLogged(const std::string& error) {
        Lines all;
        for (const std::string& line : linesOf(error)) {
            const std::string begin = "dirt: ", warning = "dirt: warning: ";
            if (line.starts_with(warning))
                all.push_back("warning: " + line.substr(warning.size()));
            else if (line.starts_with(begin))
                all.push_back("note: " + line.substr(begin.size()));
            else
                all.push_back("note: wrote " + line);
        }
        return all;
    }

    TemporaryFolder folder_;
    const std::string log_ = folder_ / "log";
    const std::string version_ = linesOf(dirt({"--version"}).out).at(0);
};

} // namespace dirt::test
