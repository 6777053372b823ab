// `dirt verify`: its table, its JSON, and what it refuses.

#include "core/verify/extremes.h"
#include "tests/cli/program.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

using namespace dirt::test;
using nlohmann::json;

namespace {

const std::vector<std::string> kKinds{"primary", "diffuse", "vertex", "edge", "axis",
                                      "grazing", "plane",   "border", "wild"};

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

TEST_F(Verify, ExtremesHaveALineForEachVariantAndBackend) {
    const Outcome run = verify({"--extremes", "--rays", "20"});
    EXPECT_EQ(run.status, 0) << run.err << run.out;
    EXPECT_EQ(run.err, "");
    for (const dirt::Extreme& extreme : dirt::extremes())
        EXPECT_NE(run.out.find("\n" + std::string(extreme.name) + " "), std::string::npos);
    EXPECT_NE(run.out.find("embree robust"), std::string::npos);
    EXPECT_NE(run.out.find(std::to_string(dirt::extremes().size()) + " variants, "),
              std::string::npos);
    EXPECT_NE(run.out.find(": 0 variants wrong\n"), std::string::npos);
}

TEST_F(Verify, ExtremesAreChosenAndReportedAsJson) {
    const Outcome run =
        verify({"--extremes", "--only", "ball,box-shared,scale-1e6", "--kinds", "edge", "--json"});
    EXPECT_EQ(run.status, 0) << run.err;
    const json report = json::parse(run.out);
    EXPECT_EQ(report["size"], json::array({64, 64}));
    ASSERT_EQ(report["extremes"].size(), 3u);
    for (const json& variant : report["extremes"]) {
        EXPECT_EQ(variant["rays"], 300);
        for (const json& backend : {variant, variant["embree"], variant["embree_robust"]})
            for (const char* key : {"missed", "false_hits", "wrong_primitive", "max_ulp_t_error",
                                    "non_finite_pixels"})
                EXPECT_TRUE(backend[key].is_number()) << key;
    }
    EXPECT_EQ(report["extremes"]["ball"]["self_shadows"], 0);
    EXPECT_TRUE(report["extremes"]["ball"]["leaks"].is_null());
    EXPECT_EQ(report["extremes"]["box-shared"]["leaks"], 0);
    EXPECT_EQ(report["extremes"]["ball"]["triangles"], 80);
}

/// What it prints, run again, finds the same wrong answers.
TEST_F(Verify, WrongAnswersCanBeRepeated) {
    for (const std::vector<std::string>& more :
         {std::vector<std::string>{"--backend", "embree"},
          {"--backend", "embree", "--extremes", "--only", "slivers,ball", "--size", "32x32"},
          {"--precision", "fast", "--extremes", "--only", "coincident"}}) {
        const Outcome run = verify(more);
        ASSERT_EQ(run.status, 1) << "nothing is wrong: the test would prove nothing";
        const size_t at = run.err.find("  again: dirt ");
        ASSERT_NE(at, std::string::npos) << run.err;
        std::vector<std::string> again = saidCommand(run.err.substr(0, at + 1000), "  again: ");
        again.push_back("--quiet");
        const Outcome repeated = dirt::test::dirt(again);
        EXPECT_EQ(repeated.status, 1);
        EXPECT_EQ(repeated.err.substr(0, at), run.err.substr(0, at));
    }
}

/// The last line explains the first wrong answer: of Embree, and of the float test.
TEST_F(Verify, EndsWithTheCommandThatShowsTheFirstWrongAnswer) {
    std::string fan; // of thin triangles, which share edges
    for (int i = 0; i <= 60; ++i) fan += "v " + std::to_string(0.03 * i) + " 1.3 -2\n";
    fan += "v 0.1 -0.7 -2.1\n";
    for (int i = 1; i <= 60; ++i)
        fan += "f " + std::to_string(i) + " " + std::to_string(i + 1) + " 62\n";
    const std::string scene = folder_.write("fan.obj", fan);
    for (const std::vector<std::string>& how :
         {std::vector<std::string>{"--backend", "embree"}, {"--precision", "fast"}}) {
        const Outcome run =
            dirt::test::dirt({"verify", scene, "--eye", "0,0,0", "--target", "0,0,-1", "--rays",
                              "20000", "--quiet", "--kinds", "edge,vertex", how[0], how[1]});
        ASSERT_EQ(run.status, 1) << "nothing is wrong: the test would prove nothing";
        const std::vector<std::string> look = saidCommand(run.err, "  look: ");
        ASSERT_FALSE(look.empty()) << run.err;
        EXPECT_EQ(run.err.find('\n', run.err.rfind("  look: ")), run.err.size() - 1);
        const Outcome shown = dirt::test::dirt(look);
        EXPECT_EQ(shown.status, 1) << shown.err;
        const std::string grade = run.err.substr(0, run.err.find(':'));
        EXPECT_NE(shown.out.find("DIFFERENT: exact arithmetic says: " + grade + "\n"),
                  std::string::npos)
            << shown.out << run.err;
    }
}

TEST_F(Verify, RefusesWhatItDoesNotKnow) {
    for (const auto& bad : std::vector<std::vector<std::string>>{{"--kinds", "sideways"},
                                                                 {"--rays", "0"},
                                                                 {"--rays", "1e6"},
                                                                 {"--rays", "-3"},
                                                                 {"--only", "ball"},
                                                                 {"--extremes", "--only", "x"},
                                                                 {"--materials", "demo"}}) {
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
