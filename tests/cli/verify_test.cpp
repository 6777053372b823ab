// `dirt verify`: its table, its JSON, and what it refuses.

#include "tests/cli/program.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

using namespace dirt::test;
using nlohmann::json;

namespace {

const std::vector<std::string> kKinds{"primary", "diffuse", "vertex", "edge", "axis", "grazing"};

class Verify : public testing::Test {
protected:
    TemporaryFolder folder_;

    Outcome verify(std::vector<std::string> arguments) {
        std::vector<std::string> all{"verify",   folder_.write("one.obj", kTriangleObj),
                                     "--eye",    "0,0,0",
                                     "--target", "0,0,-1",
                                     "--rays",   "300",
                                     "--quiet"};
        all.insert(all.end(), arguments.begin(), arguments.end());
        return dirt::test::dirt(all);
    }
};

} // namespace

#ifdef DIRT_HAVE_EMBREE

TEST_F(Verify, PrintsALineForEachKindAndBackend) {
    const Outcome run = verify({});
    EXPECT_EQ(run.status, 0) << run.err;
    for (const std::string& kind : kKinds) EXPECT_NE(run.out.find("\n" + kind), std::string::npos);
    EXPECT_NE(run.out.find("embree robust"), std::string::npos);
    EXPECT_EQ(run.err, "");
}

TEST_F(Verify, JsonHasTheCountsOfAllThree) {
    const Outcome run = verify({"--json", "--seed", "3", "--view", "single"});
    EXPECT_EQ(run.status, 0) << run.err;
    const json report = json::parse(run.out);
    EXPECT_EQ(report["triangles"], 1);
    EXPECT_EQ(report["view"], "single");
    for (const std::string& name : kKinds) {
        const json& kind = report["kinds"][name];
        EXPECT_EQ(kind["rays"].get<int>() + kind["outside_view"].get<int>(), 300) << name;
        for (const char* key : {"missed", "false_hits", "wrong_primitive"}) {
            EXPECT_EQ(kind[key], 0) << name << " " << key;
            EXPECT_TRUE(kind["embree"].contains(key)) << name << " " << key;
            EXPECT_TRUE(kind["embree_robust"].contains(key)) << name << " " << key;
        }
        EXPECT_LE(kind["max_relative_t_error"].get<double>(), 0x1p-23) << name;
    }
    EXPECT_EQ(report["kinds"]["primary"]["outside_view"], 0);
}

TEST_F(Verify, KindsAreChosen) {
    const Outcome run = verify({"--kinds", "edge,axis", "--json"});
    EXPECT_EQ(run.status, 0) << run.err;
    const json report = json::parse(run.out);
    EXPECT_EQ(report["kinds"].size(), 2u);
    EXPECT_TRUE(report["kinds"].contains("edge"));
}

TEST_F(Verify, RefusesWhatItDoesNotKnow) {
    for (const auto& bad : std::vector<std::vector<std::string>>{
             {"--kinds", "sideways"}, {"--rays", "0"}, {"--rays", "1e6"}, {"--rays", "-3"}}) {
        const Outcome run = verify(bad);
        EXPECT_EQ(run.status, 2) << bad[1];
        EXPECT_EQ(run.out, "");
        EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    }
}

#else

TEST_F(Verify, SaysThatEmbreeIsMissing) {
    EXPECT_EQ(verify({}).status, 3);
}

#endif
