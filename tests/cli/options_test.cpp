// An option that a command or a backend has no use for is refused in one line. The tables here say
// who honours what; that of the program is app/cli/option_scope.cpp.

#include "tests/cli/program.h"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

namespace dirt::test {
namespace {

using Names = std::set<std::string>;

/// With a value that some backend would do something with.
const std::vector<std::pair<std::string, std::string>> kOptions = {{"--backend", "cpu"},
                                                                   {"--device", "0"},
                                                                   {"--view", "full"},
                                                                   {"--tile", "8"},
                                                                   {"--bins", "8"},
                                                                   {"--view-size", "64"},
                                                                   {"--max-mip", "2"},
                                                                   {"--traversal", "linear"},
                                                                   {"--primary", "raster"},
                                                                   {"--fetch", "raster"},
                                                                   {"--visibility", "traced"},
                                                                   {"--shading", "packed"},
                                                                   {"--precision", "fast"},
                                                                   {"--size", "8x8"},
                                                                   {"--spp", "2"},
                                                                   {"--bounces", "2"},
                                                                   {"--ray-type", "diffuse"},
                                                                   {"--seed", "1"},
                                                                   {"--eye", "1,2,3"},
                                                                   {"--target", "1,2,9"},
                                                                   {"--up", "0,1,0"},
                                                                   {"--fov", "50"},
                                                                   {"--frame", "1"},
                                                                   {"--threads", "1"},
                                                                   {"--memory", "4G"},
                                                                   {"--materials", "demo"}};
const std::vector<std::string> kFlags = {"--quiet", "--no-cache", "--strict"};

Names everyOptionBut(const Names& honoured) {
    Names names{"--camera"};
    for (const auto& [option, value] : kOptions) names.insert(option);
    names.insert(kFlags.begin(), kFlags.end());
    for (const std::string& name : honoured) names.erase(name);
    return names;
}

struct CommandRow {
    std::string name;
    Names idle; ///< options that it has no use for
};
const CommandRow kCommands[] = {{"render", {}},
                                {"info", {}},
                                {"dump", {"--spp"}},
                                {"check", {"--spp", "--backend"}},
                                {"verify",
                                 {"--spp", "--bounces", "--ray-type", "--primary", "--fetch",
                                  "--visibility", "--shading", "--materials"}},
                                {"bench frame", {"--spp", "--bounces"}},
                                {"bench tradeoff", {"--spp"}},
                                {"bench scaling", {"--spp", "--frame"}},
                                {"replay", everyOptionBut({"--threads", "--quiet"})}};

/// The command with what it needs besides, and a scene that is not there.
std::vector<std::string> commandLine(const std::string& name, const TemporaryFolder& folder) {
    std::vector<std::string> line;
    for (size_t i = 0; i < name.size();) {
        const size_t end = std::min(name.find(' ', i), name.size());
        line.push_back(name.substr(i, end - i));
        i = end + 1;
    }
    if (name != "bench scaling") line.push_back(folder / "none.obj");
    if (name == "bench scaling")
        line.insert(line.end(), {"-o", folder.write("file", "") + "/none", "--most", "10000"});
    if (name == "dump" || name == "bench tradeoff") line.insert(line.end(), {"-o", folder / "out"});
    if (name == "check") line.insert(line.end(), {"--backends", "cpu,cpu", "--quiet"});
    return line;
}

/// One line with status 2. Returns whether it says that \p option has no effect.
bool isRefused(const std::vector<std::string>& line, const std::string& option) {
    const Outcome run = dirt(line);
    EXPECT_EQ(run.status, 2) << option;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    return run.err.rfind("dirt: " + option + ": has no effect ", 0) == 0;
}

#ifdef DIRT_HAVE_EMBREE // else verify and bench end before
TEST(Options, EachCommandRefusesWhatItHasNoUseFor) {
    const TemporaryFolder folder;
    for (const CommandRow& command : kCommands)
        for (const auto& [option, value] : kOptions) {
            SCOPED_TRACE(command.name);
            auto line = commandLine(command.name, folder);
            line.insert(line.end(), {option, value});
            if (option == "--device" && command.name != "replay") continue; // see below
            EXPECT_EQ(isRefused(line, option), command.idle.contains(option)) << option;
        }
}
#endif

TEST(Options, HelpListsWhatACommandHonours) {
    for (const CommandRow& command : kCommands) {
        const TemporaryFolder folder;
        std::vector<std::string> line = commandLine(command.name, folder);
        line.resize(command.name.find(' ') == std::string::npos ? 1 : 2);
        line.push_back("--help");
        const std::string help = dirt(line).out;
        for (const auto& [option, value] : kOptions)
            EXPECT_EQ(help.find("  " + option + " ") != std::string::npos,
                      !command.idle.contains(option))
                << command.name << " " << option;
        for (const std::string& flag : kFlags)
            EXPECT_EQ(help.find("  " + flag + " ") != std::string::npos,
                      !command.idle.contains(flag))
                << command.name << " " << flag;
        // Every option of all commands is in the tables above.
        Names known(kFlags.begin(), kFlags.end());
        for (const auto& [option, value] : kOptions) known.insert(option);
        if (command.name != "verify") continue;
        // Which model has cameras is not the command's business; --devices is info's, and spoken
        // of.
        known.merge(Names{"--help", "--rays", "--kinds", "--json", "--camera", "--devices",
                          "--extremes", "--only", "--log"});
        for (size_t at = help.find("--"); at != std::string::npos; at = help.find("--", at + 2)) {
            if (help[at - 1] != ' ' && help[at - 1] != ',') continue;
            const size_t end = help.find_first_not_of("-abcdefghijklmnopqrstuvwxyz", at);
            EXPECT_TRUE(known.contains(help.substr(at, end - at))) << help.substr(at, end - at);
        }
    }
}

TEST(Options, ReplayRefusesTheFlagsOfScenes) {
    const TemporaryFolder folder;
    for (const char* flag : {"--no-cache", "--strict"})
        EXPECT_TRUE(isRefused({"replay", folder / "none", flag}, flag));
    EXPECT_TRUE(isRefused({"replay", folder / "none", "--camera", "1"}, "--camera"));
    EXPECT_FALSE(isRefused({"replay", folder / "none", "--quiet"}, "--quiet"));
}

/// Before the backend is made, so that it need not be there.
TEST(Options, EachBackendRefusesWhatItHasNoUseFor) {
    const Names ofGrid = {"--tile",      "--bins",    "--view-size", "--max-mip",
                          "--traversal", "--primary", "--fetch",     "--precision"};
    const TemporaryFolder folder;
    for (const std::string backend : {"cpu", "gl", "embree"})
        for (const char* command : {"info", "render", "dump"})
            for (const auto& [option, value] : kOptions) {
                if (option == "--backend" || (option == "--spp" && command == std::string("dump")))
                    continue;
                auto line = commandLine(command, folder);
                line.insert(line.end(), {"--backend", backend, option, value});
                EXPECT_EQ(isRefused(line, option),
                          option == "--device" ? backend != "gl"
                                               : backend == "embree" && ofGrid.contains(option))
                    << backend << " " << command << " " << option;
            }
    // What Embree does anyway may be said.
    for (const auto& [option, value] : {std::pair<std::string, std::string>{"--primary", "traced"},
                                        {"--fetch", "direct"},
                                        {"--precision", "exact"}})
        EXPECT_FALSE(
            isRefused({"info", folder / "none.obj", "--backend", "embree", option, value}, option));
}

#ifdef DIRT_HAVE_EMBREE
/// One of two is enough.
TEST(Options, CheckHonoursWhatOneOfItsBackendsDoes) {
    const TemporaryFolder folder;
    const auto refused = [&](const char* backends, const char* option, const char* value) {
        return isRefused(
            {"check", folder / "none.obj", "--quiet", "--backends", backends, option, value},
            option);
    };
    EXPECT_FALSE(refused("cpu,embree", "--tile", "4"));
    EXPECT_TRUE(refused("embree,embree", "--tile", "4"));
    EXPECT_TRUE(refused("cpu,embree", "--device", "0"));
}
#endif

TEST(Options, OthersThatLeaveOneWithoutEffectAreNamed) {
    const TemporaryFolder folder;
    const std::string scene = litTriangle(folder),
                      single =
                          folder.write("single.scene",
                                       "<world><tracing faces=\"single\"/><object file=\"a.obj\"/>"
                                       "<user position=\"0 0 0\" lookat=\"0 0 -1\"/></world>");
    EXPECT_TRUE(isRefused({"info", scene, "--view", "single", "--view-size", "64"}, "--view-size"));
    EXPECT_TRUE(isRefused({"info", single, "--view-size", "64"}, "--view-size"));
    EXPECT_TRUE(isRefused({"info", scene, "--traversal", "linear", "--max-mip", "2"}, "--max-mip"));
    EXPECT_TRUE(
        isRefused({"info", scene, "--ray-type", "visibility", "--bounces", "4"}, "--bounces"));
    EXPECT_EQ(dirt({"info", single, "--view", "full", "--view-size", "64"}).status, 0);
}

TEST(Options, WhatTheSceneLeavesWithoutEffectIsSaidOnce) {
    const TemporaryFolder folder;
    const std::string scene = litTriangle(folder), out = folder / "a.png";
    const auto says = [&](std::vector<std::string> more, const std::string& text) {
        std::vector<std::string> line{"render", scene, "--size", "8x8", "--spp", "1", "-o", out};
        line.insert(line.end(), more.begin(), more.end());
        const Outcome run = dirt(line);
        EXPECT_EQ(run.status, 0);
        const size_t at = run.err.find(text);
        EXPECT_NE(at, std::string::npos) << run.err;
        EXPECT_EQ(run.err.find(text, at + 1), std::string::npos) << run.err;
        line.push_back("--quiet");
        EXPECT_EQ(dirt(line).err, "");
    };
    says({"--frames", "0:2"}, "dirt: warning: --frames: the scene does not move: all are alike\n");
    says({"--frame", "2"}, "dirt: warning: --frame: the scene does not move\n");
    EXPECT_NE(dirt({"check", scene, "--size", "8x8", "--backends", "cpu,cpu"})
                  .err.find("--backends cpu,cpu: a backend is compared with itself\n"),
              std::string::npos);
}

} // namespace
} // namespace dirt::test
