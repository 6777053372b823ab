// docs/first-hour.md as its readers follow it: each block of commands is run, and what the page
// says that they print is printed.

#include "tests/cli/program.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace dirt::test {
namespace {

/// Commands of a ```sh block, and the lines of the ```text block after it.
struct Step {
    std::string commands;
    std::vector<std::string> said;
};

std::vector<Step> stepsOf(const std::string& page) {
    std::vector<Step> steps;
    std::istringstream lines(page);
    std::string fence; // of the block that the line is in
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("```")) {
            fence = fence.empty() ? line : "";
            if (fence == "```sh") steps.emplace_back();
        } else if (fence == "```sh") {
            steps.back().commands += line + "\n";
        } else if (fence == "```text" && !line.empty()) {
            steps.back().said.push_back(line);
        }
    }
    return steps;
}

/// Whether a line of \p output begins with \p line, whose "..." stands for anything.
bool isSaid(const std::string& output, const std::string& line) {
    std::istringstream lines(output);
    for (std::string printed; std::getline(lines, printed);) {
        size_t at = 0, from = 0;
        for (bool more = true; more && at != printed.npos;) {
            const size_t gap = line.find("...", from);
            const std::string part = line.substr(from, gap - from);
            const size_t found = printed.find(part, at);
            at = from == 0 && found != 0 ? printed.npos
                 : found == printed.npos ? found
                                         : found + part.size();
            more = gap != line.npos;
            from = gap + 3;
        }
        if (at != printed.npos) return true;
    }
    return false;
}

TEST(FirstHour, LinesAreFoundWithTheirGaps) {
    const std::string output = "one two three\nfour  five\n";
    for (const char* said : {"one two", "one...three", "four...", "one two three", "..."})
        EXPECT_TRUE(isSaid(output, said)) << said;
    for (const char* other : {"two", "one...four", "three...one", "four five"})
        EXPECT_FALSE(isSaid(output, other)) << other;
}

TEST(FirstHour, GoesAsThePageSays) {
    if (dirt({"info", "--devices"}).status != 0) GTEST_SKIP() << "there is no OpenGL";
    const TemporaryFolder clone;
    for (const char* part : {"scenes", "shaders", "examples"})
        std::filesystem::copy(std::string(DIRT_SOURCE_DIR "/") + part, clone.path() / part,
                              std::filesystem::copy_options::recursive);
    // What the build makes beside the scenes.
    ASSERT_EQ(dirt({"generate", "cornell", "-o", clone / "scenes/generated"}).status, 0);
    std::filesystem::create_symlink(DIRT_PROGRAM, clone.path() / "dirt");
    const std::vector<Step> steps = stepsOf(readFile(DIRT_SOURCE_DIR "/docs/first-hour.md"));
    EXPECT_GE(steps.size(), 5u);
    for (const Step& step : steps) {
        const Outcome run = Process("/bin/sh", {"-c", "exec 2>&1\n" + step.commands}, [&] {
                                if (chdir(clone.path().c_str()) != 0) _exit(126);
                            }).wait();
        for (const std::string& line : step.said)
            EXPECT_TRUE(isSaid(run.out, line)) << step.commands << "does not say\n"
                                               << line << "\nbut\n"
                                               << run.out;
    }
}

} // namespace
} // namespace dirt::test
