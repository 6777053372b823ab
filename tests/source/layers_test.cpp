// Arrows between folders go in one direction: each includes what stands before it in the list, and
// nothing else. So there are no circles, and a reader can begin at the ground.

#include "tests/source/sources.h"

#include <regex>
#include <set>
#include <utility>

#include <gtest/gtest.h>

namespace dirt {
namespace {

/// From the ground up. Folders of one floor do not know each other.
const std::vector<std::vector<std::string>> kFloors{
    {"shaders/shared"},
    {"core/base"},
    {"core/scene"},
    {"core/grid"},
    {"core/trace"},
    {"core/path"},
    {"core/frame"},
    {"core/io"},
    {"core/aov", "core/compare", "core/cost", "core/dump", "core/explain", "core/probe",
     "core/verify"},
    {"core/check", "core/preview"},
    {"core/replay"},
    {"backend_cpu/build"},
    {"backend_cpu/light"},
    {"backend_cpu/trace"},
    {"backend_cpu/image"},
    {"backend_cpu", "backend_embree", "backend_gl", "scenes"},
    {"bench"},
    {"app"},
};

/// The floor and the folder of a file; -1 where it is on none.
std::pair<int, std::string> placeOf(const std::string& file) {
    for (size_t floor = 0; floor < kFloors.size(); ++floor)
        for (const std::string& folder : kFloors[floor])
            if (file.starts_with(folder + "/")) return {(int) floor, folder};
    return {-1, ""};
}

TEST(Layers, ArrowsGoDown) {
    std::set<std::string> seen;
    for (const std::string& file : test::sourceFiles({".h", ".cpp"})) {
        const auto [from, own] = placeOf(file);
        if (from < 0) {
            // A folder that the list forgot could have any arrows.
            EXPECT_TRUE(file.starts_with("tests/") || file.starts_with("examples/")) << file;
            continue;
        }
        seen.insert(own);
        for (const std::string& name : test::includesOf(file)) {
            const auto [to, other] = placeOf(name);
            EXPECT_TRUE(to >= 0 && (to < from || other == own))
                << file << " includes " << name << ", which does not stand below it";
        }
    }
    for (const auto& floor : kFloors)
        for (const std::string& folder : floor) EXPECT_TRUE(seen.contains(folder)) << folder;
}

} // namespace
} // namespace dirt
