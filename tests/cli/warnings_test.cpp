// Every command with a scene says what info says of it.

#include "tests/cli/program.h"

#include <map>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace dirt::test {
namespace {

class Warnings : public testing::Test {
protected:
    void SetUp() override {
        // Of the first model's small triangles float32 keeps nothing so far from 0, in the file's
        // coordinates or where a scene places them; its large one keeps them there.
        folder_.write("a.obj", "mtllib none.mtl\nv 0 0 0\nv 1e7 0 0\nv 0 1e7 0\n"
                               "v 1e7 1e7 0\nv 1e7 10000000.1 0\nv 10000000.1 1e7 0\n"
                               "f 1 2 3\nf 4 5 6\n");
        scenes_ = {
            folder_ / "a.obj",
            folder_.write("a.scene", "<world><object file='a.obj'/>"
                                     "<user position='0 0 1e12' lookat='0 0 0'/></world>"),
        };
    }
    std::vector<std::string> of(const std::string& command, const std::string& scene) {
        std::vector<std::string> arguments{command, scene, "--size", "16x8", "--bounces", "1"};
        const std::map<std::string, std::vector<std::string>> more{
            {"render", {"--spp", "1", "-o", folder_ / "a.exr"}},
            {"dump", {"-o", folder_ / "dump"}},
            {"check", {"--backends", "cpu,cpu"}},
            {"verify", {"--rays", "10"}},
            {"info", {"--json"}},
        };
        arguments.insert(arguments.end(), more.at(command).begin(), more.at(command).end());
        if (command == "verify") arguments.erase(arguments.begin() + 4, arguments.begin() + 6);
        const Outcome run = dirt(arguments);
        if (run.status == 3) return {}; // verify without Embree
        EXPECT_EQ(run.status, 0) << run.err;
        if (command == "info") return nlohmann::json::parse(run.out)["warnings"];
        std::vector<std::string> lines;
        std::istringstream text(run.err);
        const std::string begin = "dirt: warning: ";
        for (std::string line; std::getline(text, line);)
            if (line.starts_with(begin) && line.find("compared with itself") == std::string::npos)
                lines.push_back(line.substr(begin.size()));
        return lines;
    }

    TemporaryFolder folder_;
    std::vector<std::string> scenes_;
};

TEST_F(Warnings, AreThoseOfInfoInEveryCommand) {
    for (const std::string& scene : scenes_) {
        const auto expected = of("info", scene);
        EXPECT_GE(expected.size(), 2u);
        for (const char* command : {"render", "dump", "check", "verify"}) {
            const auto found = of(command, scene);
            if (found.empty() && std::string(command) == "verify") continue;
            EXPECT_EQ(found, expected) << command << " " << scene;
        }
    }
}

} // namespace
} // namespace dirt::test
