// `dirt replay` judges dumps that an independent script wrote by rational arithmetic: the right
// one, and others with one fault each, which it has to name in its pass and place.

#include "tests/cli/program.h"

#include <filesystem>
#include <functional>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace dirt::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

class Replay : public testing::Test {
protected:
    static void SetUpTestSuite() {
        folder_ = new TemporaryFolder;
        const Outcome run =
            start("/usr/bin/python3", {std::string(DIRT_SOURCE_DIR) + "/tests/replay/write_dump.py",
                                       *folder_ / "dumps"});
        written_ = run.status == 0;
        EXPECT_TRUE(written_ || run.status == 127) << run.err;
    }
    static void TearDownTestSuite() { delete folder_; }
    void SetUp() override {
        if (!written_) GTEST_SKIP() << "there is no /usr/bin/python3";
    }

    static std::string dump(const std::string& name) { return *folder_ / ("dumps/" + name); }

    /// A copy of the right dump with one file edited.
    static std::string edited(const std::string& file,
                              const std::function<void(std::string&)>& edit) {
        const std::string copy = *folder_ / "edited";
        fs::remove_all(copy);
        fs::copy(dump("right"), copy);
        std::string text = readFile(copy + "/" + file);
        edit(text);
        folder_->write("edited/" + file, text);
        return copy;
    }

    static Json replay(const std::string& folder, int status) {
        const Outcome run = dirt({"replay", folder, "--json", "--quiet"});
        EXPECT_EQ(run.status, status) << run.err;
        EXPECT_EQ(run.err, "");
        return Json::parse(run.out);
    }

    static TemporaryFolder* folder_;
    static bool written_;
};
TemporaryFolder* Replay::folder_ = nullptr;
bool Replay::written_ = false;

std::string nameOf(const Json& pass) {
    return pass["pass"].get<std::string>() +
           (pass["event"].is_null() ? "" : " " + pass["event"].dump());
}

void replaceOnce(std::string& text, const std::string& what, const std::string& by) {
    const size_t at = text.find(what);
    ASSERT_NE(at, std::string::npos) << what;
    text.replace(at, what.size(), by);
}

/// Line \p number of \p text, counted from 1, becomes \p line.
void setLine(std::string& text, size_t number, const std::string& line) {
    size_t begin = 0;
    for (size_t i = 1; i < number; ++i) begin = text.find('\n', begin) + 1;
    text.replace(begin, text.find('\n', begin) - begin, line);
}

TEST_F(Replay, TheRightDumpIsRight) {
    const Json json = replay(dump("right"), 0);
    EXPECT_TRUE(json["first_wrong"].is_null());
    EXPECT_EQ(json["verdict"], "all is right");
    ASSERT_EQ(json["passes"].size(), 6u);
    for (const Json& pass : json["passes"]) {
        EXPECT_EQ(pass["compared"], pass["right"]);
        const bool isAtEye = pass["buffer"] == "triangles at the eye";
        EXPECT_GT(pass["compared"].get<int>(), isAtEye ? -1 : 20) << pass;
    }
}

TEST_F(Replay, EachFaultIsNamedInItsPassAndPlace) {
    const Json faults = Json::parse(readFile(dump("faults.json")));
    ASSERT_EQ(faults.size(), 17u);
    for (const auto& [name, expected] : faults.items()) {
        if (expected.is_null()) continue;
        SCOPED_TRACE(name);
        const Json json = replay(dump(name), 1);
        EXPECT_EQ(json["first_wrong"], expected["pass"]);
        for (const Json& pass : json["passes"]) {
            const char* inherited = pass["pass"] == "Trace"        ? "inherited"
                                    : pass["pass"] == "Visibility" ? "inherited_shadows"
                                                                   : "";
            EXPECT_EQ(pass["inherited"], expected.value(inherited, 0)) << pass;
            if (nameOf(pass) != expected["pass"] || pass["buffer"] == "triangles at the eye") {
                EXPECT_EQ(pass["wrong"], 0u) << pass;
                continue;
            }
            ASSERT_TRUE(pass.contains("first"));
            for (const char* key : {"view", "level", "tile", "bin", "primitive", "pixel"})
                EXPECT_EQ(pass["first"].value(key, Json()),
                          expected.value(key, pass["first"].value(key, Json())))
                    << key;
            EXPECT_EQ(pass["faults"].size(), 1u);
            const uint64_t count = pass["faults"].value(expected["fault"].get<std::string>(), 0);
            EXPECT_EQ(count, expected["count"]) << pass["faults"];
            EXPECT_EQ(json["verdict"], nameOf(pass) + " is the first pass that is wrong: " +
                                           pass["first"]["text"].get<std::string>());
        }
    }
}

TEST_F(Replay, TheLastLineSaysItInWords) {
    const auto lastLine = [](const std::string& folder) {
        const std::string out = dirt({"replay", folder}).out;
        return out.substr(out.rfind('\n', out.size() - 2) + 1);
    };
    EXPECT_EQ(lastLine(dump("right")), "all is right\n");
    EXPECT_EQ(lastLine(dump("lacking")), "FillPrimitives is the first pass that is wrong: view -X, "
                                         "column 1, row 1, bin 3 lacks triangle 7\n");
    EXPECT_EQ(lastLine(dump("wrong-primitive"))
                  .find("Trace 1 is the first pass that is wrong: pixel 3,0 has triangle "),
              0u);
    EXPECT_NE(lastLine(dump("missed-occlusion"))
                  .find("Visibility 1 is the first pass that is wrong: pixel "),
              std::string::npos);
}

TEST_F(Replay, EntriesTwiceAndTilesThatDoNotListTheHitAreFaults) {
    std::string entry;
    const std::string twice = edited("ids.csv", [&](std::string& text) {
        entry = text.substr(text.find('\n') + 1);
        entry.resize(entry.find('\n') + 1);
        text += entry;
    });
    const Json lists = replay(twice, 1)["passes"][2];
    EXPECT_EQ(lists["faults"], Json({{"listed twice", 1}}));

    // All records filed in one tile: most do not belong there.
    const std::string filed = edited("hits.1.csv", [](std::string& text) {
        std::string out;
        for (size_t at = 0; at < text.size();) {
            const size_t end = text.find('\n', at);
            out += text.substr(at, end - at) + (at == 0 ? ",view,tile\n" : ",3,5\n");
            at = end + 1;
        }
        text = out;
    });
    const Json hits = replay(filed, 1)["passes"][4];
    EXPECT_GT(hits["faults"]["misfiled"], 20);
    EXPECT_EQ(hits["faults"].size(), 1u);
    EXPECT_NE(hits["first"]["text"].get<std::string>().find(
                  "is filed in view -Y, column 1, row 1, which does not list it"),
              std::string::npos)
        << hits;
}

/// \p text of a table with what \p cells(line) say of each line, counted from 0, the names, after
/// the first \p kept cells.
std::string withCells(const std::string& text, size_t kept,
                      const std::function<std::string(size_t)>& cells) {
    std::string out;
    size_t number = 0;
    for (size_t at = 0; at < text.size(); ++number) {
        const size_t end = text.find('\n', at);
        size_t stop = at;
        for (size_t i = 0; i < kept; ++i) stop = std::min(text.find(',', stop + 1), end);
        out += text.substr(at, stop - at) + cells(number) + "\n";
        at = end + 1;
    }
    return out;
}

TEST_F(Replay, ShadowRaysMaySayLessOrMore) {
    const auto with = [&](size_t kept, const std::function<std::string(size_t)>& cells) {
        return edited("shadowrays.1.csv",
                      [&](std::string& text) { text = withCells(text, kept, cells); });
    };
    // Without blockers, and with what they skip: nothing.
    EXPECT_EQ(replay(with(8, [](size_t) { return ""; }), 0)["passes"][5]["right"], 96);
    EXPECT_EQ(replay(with(9, [](size_t line) { return line == 0 ? ",skip" : ",4294967295"; }),
                     0)["passes"][5]["right"],
              96);
    // All blockers in one tile: most are not listed there.
    const Json filed =
        replay(with(9, [](size_t line) { return line == 0 ? ",view,column,row" : ",3,1,1"; }),
               1)["passes"][5];
    EXPECT_GT(filed["faults"]["misfiled"], 10);
    EXPECT_EQ(filed["faults"].size(), 1u);
    EXPECT_NE(filed["first"]["text"].get<std::string>().find(
                  " is filed in view -Y, column 1, row 1, which does not list it"),
              std::string::npos)
        << filed;
    // A ray that ends before what blocked it, and one that goes on beyond the light.
    const auto ending = [&](const char* tMax) {
        return edited("shadowrays.1.csv", [&](std::string& text) {
            text = withCells(text, 6, [&](size_t line) {
                return line == 0 ? std::string(",tMax,occluded") : std::string(",") + tMax + ",0";
            });
        });
    };
    EXPECT_EQ(replay(ending("0"), 0)["passes"][5]["right"], 96);
    EXPECT_EQ(replay(ending("1"), 1)["passes"][5]["faults"], Json({{"missed occlusion", 26}}));
    EXPECT_GT(replay(ending("9"), 1)["passes"][5]["faults"]["missed occlusion"], 40);

    const Outcome part =
        dirt({"replay", with(9, [](size_t line) { return line == 0 ? ",view,row" : ",3,1"; })});
    EXPECT_EQ(part.status, 2);
    EXPECT_NE(part.err.find("shadowrays.1.csv:1: has some of the columns view, column and row"),
              std::string::npos)
        << part.err;
}

TEST_F(Replay, TrianglesAtTheEyeAreJudged) {
    const Json json = replay(
        edited("manifest.json",
               [](std::string& text) { replaceOnce(text, "\"at_eye\": []", "\"at_eye\": [3]"); }),
        1);
    EXPECT_EQ(json["passes"][3]["faults"], Json({{"loose", 1}}));
    EXPECT_EQ(json["verdict"], "FillPrimitives is the first pass that is wrong: at_eye has "
                               "triangle 3, which does not hold the eye");
}

TEST_F(Replay, BuffersMayBeLeftOut) {
    const auto without = [&](const std::string& names) {
        return edited("manifest.json", [&](std::string& text) {
            Json json = Json::parse(text);
            for (size_t i = json["files"].size(); i-- > 0;)
                if ((" " + names + " ")
                        .find(" " + json["files"][i]["buffer"].get<std::string>() + " ") !=
                    names.npos)
                    json["files"].erase(i);
            text = json.dump();
        });
    };
    EXPECT_EQ(replay(without("rays hits shadowrays"), 0)["passes"].size(), 4u);
    EXPECT_EQ(replay(without("rays hits"), 0)["passes"].size(), 5u);
    EXPECT_EQ(replay(without("shadowrays"), 0)["passes"].size(), 5u);
    EXPECT_EQ(replay(without("ids rays hits"), 0)["passes"].size(), 4u);
    EXPECT_EQ(replay(without("depth ids"), 0)["passes"].size(), 3u); // at_eye, hits, shadow rays
    const Outcome noDepth = dirt({"replay", without("depth")});
    EXPECT_EQ(noDepth.status, 2);
    EXPECT_NE(noDepth.err.find("manifest.json: has ids without depth"), std::string::npos);
    EXPECT_EQ(dirt({"replay", without("triangles")}).status, 2);
    EXPECT_EQ(dirt({"replay", without("rays")}).status, 2);
}

TEST_F(Replay, NumbersMayBeHexadecimal) {
    const std::string folder = edited("rays.1.csv", [](std::string& text) {
        std::string out = text.substr(0, text.find('\n') + 1);
        for (size_t at = out.size(); at < text.size();) {
            const size_t end = text.find_first_of(",\n", at);
            char number[40];
            std::snprintf(number, sizeof number, "%a", std::stod(text.substr(at, end - at)));
            out += number + text.substr(end, 1);
            at = end + 1;
        }
        ASSERT_NE(out.find("-0x1."), out.npos);
        text = out;
    });
    EXPECT_EQ(replay(folder, 0)["passes"][4]["right"], 96);
}

TEST_F(Replay, WhatHasNoEffectIsNamedOnce) {
    const std::string folder = edited("depth.csv", [](std::string& text) {
        replaceOnce(text, "near,far", "near,far,colour");
        for (size_t at = text.find('\n') + 1; at < text.size(); at = text.find('\n', at) + 1)
            text.insert(text.find('\n', at), ",1");
    });
    std::string manifest = readFile(folder + "/manifest.json");
    replaceOnce(manifest, "\"files\": [",
                "\"mood\": 1, \"files\": [{\"file\": \"a.b\", \"buffer\": \"leaves\"},");
    folder_->write("edited/manifest.json", manifest);
    const Outcome run = dirt({"replay", folder});
    EXPECT_EQ(run.status, 0);
    EXPECT_EQ(run.err, "dirt: warning: manifest.json: key mood: has no effect\n"
                       "dirt: warning: buffer leaves: has no effect\n"
                       "dirt: warning: depth.csv: column colour: has no effect\n");
}

TEST_F(Replay, BadTablesEndInOneLineWithTheirPlace) {
    struct Case {
        std::string file;
        size_t line;
        std::string text, says;
    };
    const std::string big(400, '9');
    const Case cases[] = {
        {"triangles.csv", 3, "1,2,3", ":3: has 3 values, not 9"},
        {"triangles.csv", 4, "1,2,3,4,5,6,7,8,nan", ":4: c.Z is 'nan', no finite float"},
        {"triangles.csv", 4, "1,2,3,4,5,6,7,8,1e99", ":4: c.Z is '1e99', no finite float"},
        {"triangles.csv", 4, "1,2,3,4,5,6,7,8,", ":4: c.Z is '', no finite float"},
        {"triangles.csv", 4, "1,2,3,4,5,6,7,8,0x", ":4: c.Z is '0x', no finite float"},
        {"triangles.csv", 2, "9,0,0,0,0,0,0,0,0", ": the largest coordinate is not in [1, 2)"},
        {"triangles.csv", 1, "a.X,a.X", ":1: has two columns 'a.X'"},
        {"triangles.csv", 1, "a.X,a.Y,a.Z,b.X,b.Y,b.Z,c.X,c.Y,x", ":1: has no column c.Z"},
        {"depth.csv", 9, "6,0,0,0,1,2", ":9: view is 6, where there are 6"},
        {"depth.csv", 9, "0,3,0,0,1,2", ":9: level is 3, where there are 3"},
        {"depth.csv", 9, "0,1,2,0,1,2", ":9: column is 2, where there are 2"},
        {"depth.csv", 9, "0,0,0,0,1,2", ":9: is there a second time"},
        {"depth.csv", 9, "0,0,-1,0,1,2", ":9: column is '-1', no whole number"},
        {"depth.csv", 9, "0,0,0,0,inf,2", ":9: near is 'inf', no finite float"},
        {"ids.csv", 2, "0,4,0,0,0", ":2: column is 4, where there are 4"},
        {"ids.csv", 2, "0,0,0,4,0", ":2: bin is 4, where there are 4"},
        {"ids.csv", 2, "0,0,0,0,25", ":2: id is 25, where there are 25"},
        {"ids.csv", 2, "0,0,0,0," + big, ":2: id is '9999"},
        {"hits.1.csv", 5, "25,1,0,0", ":5: primitive is 25, where there are 25 triangles"},
        {"hits.1.csv", 1, "primitive,t,u,v,view", ":2: has 4 values, not 5"},
        {"shadowrays.1.csv", 3, "0,0,0,0,0,1,1,2,0", ":3: occluded is 2, not 0 or 1"},
        {"shadowrays.1.csv", 3, "0,0,0,0,0,1,1,1,25",
         ":3: blocker is 25, where there are 25 triangles"},
        {"shadowrays.1.csv", 1,
         "origin.X,origin.Y,origin.Z,direction.X,direction.Y,direction.Z,occluded",
         ":1: has no column tMax"},
        {"rays.1.csv", 97, "", ":97: has 1 values, not 6"},
        {"rays.1.csv", 1, "", ":1: has no column origin.X"}};
    for (const Case& bad : cases) {
        SCOPED_TRACE(bad.says);
        const std::string folder =
            edited(bad.file, [&](std::string& text) { setLine(text, bad.line, bad.text); });
        const Outcome run = dirt({"replay", folder});
        EXPECT_EQ(run.status, 2);
        EXPECT_EQ(run.out, "");
        EXPECT_EQ(run.err.find("dirt: " + folder + "/" + bad.file + bad.says), 0u) << run.err;
        EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    }
    // Of a level that is not whole.
    const Outcome run = dirt({"replay", edited("depth.csv", [](std::string& text) {
                                  text.resize(text.rfind('\n', text.size() - 2) + 1);
                              })});
    EXPECT_EQ(run.status, 2);
    EXPECT_NE(run.err.find("depth.csv: lacks levels of the pyramid"), std::string::npos) << run.err;
}

TEST_F(Replay, BadManifestsEndInOneLine) {
    const std::pair<std::string, std::string> cases[] = {
        {"\"tile\": 16", "\"tile\": 0"},
        {"\"tile\": 16", "\"tile\": 32"},
        {"\"bins\": 4", "\"bins\": 1000"},
        {"\"bins\": 4", "\"bins\": \"4\""},
        {"\"size\": [\n  12", "\"size\": [\n  13"},
        {"\"view\": \"full\"", "\"view\": \"single\""},
        {"\"view\": \"full\"", "\"view\": \"all\""},
        {"\"sign\": -1", "\"sign\": 1"},
        {"\"sign\": -1", "\"sign\": 0.5"},
        {"\"name\": \"-X\"", "\"name\": \"+X\""},
        {"-0.5", "-1.5"},
        {"-1.0", "-0.9"},
        {"\"at_eye\": []", "\"at_eye\": [25]"},
        {"\"file\": \"ids.csv\"", "\"file\": \"../right/ids.csv\""},
        {"\"file\": \"ids.csv\"", "\"file\": \"ids.txt\""},
        {"\"file\": \"ids.csv\"", "\"file\": \"none.csv\""},
        {"\"buffer\": \"ids\"", "\"buffer\": \"depth\""},
        {"\"event\": 1", "\"event\": null"},
        {"\"event\": 1", "\"event\": 2"},
        {"\"files\"", "\"exact\": false, \"files\""},
        {"{", "["},
        {"{", ""}};
    for (const auto& [what, by] : cases) {
        SCOPED_TRACE(what + " becomes " + by);
        const std::string folder =
            edited("manifest.json", [&](std::string& text) { replaceOnce(text, what, by); });
        const Outcome run = dirt({"replay", folder});
        EXPECT_EQ(run.status, 2) << run.out;
        EXPECT_EQ(run.out, "");
        EXPECT_EQ(run.err.find("dirt: " + folder + "/"), 0u) << run.err;
        EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    }
    EXPECT_EQ(dirt({"replay", *folder_ / "nothing"}).status, 2);
}

TEST_F(Replay, AgainstABackendTellsHowItDiffers) {
    const auto differences = [&](const std::string& name, int status) {
        const Outcome run = dirt({"replay", dump(name), "--against", "cpu", "--json", "--quiet"});
        EXPECT_EQ(run.status, status) << run.err;
        std::map<std::string, uint64_t> different;
        const Json json = Json::parse(run.out);
        for (const Json& row : json["against"]["rows"])
            different[row["pass"].get<std::string>()] += row["different"].get<uint64_t>();
        return different;
    };
    // Bounds and lists of this engine have another guard band: within G1 and G2, and not equal.
    std::map<std::string, uint64_t> right = differences("right", 0);
    EXPECT_EQ(right["Trace"], 0u);
    EXPECT_EQ(differences("missed", 1)["Trace"], 1u);
    EXPECT_EQ(differences("wrong-primitive", 1)["Trace"], 1u);
    EXPECT_GT(differences("lost", 1)["FillPrimitives"], right["FillPrimitives"] + 20);
    EXPECT_EQ(right["Visibility"], 0u);
    EXPECT_EQ(differences("missed-occlusion", 1)["Visibility"], 1u);

    // Borders that no backend makes.
    const std::string odd = edited("manifest.json", [](std::string& text) {
        for (size_t at = text.find("0.5"); at != text.npos; at = text.find("0.5", at + 1))
            text.replace(at, 3, "0.4");
    });
    const Outcome run = dirt({"replay", odd, "--against", "cpu"});
    EXPECT_EQ(run.status, 2);
    EXPECT_NE(run.err.find("manifest.json: view_frames[0] has other axes or borders"),
              std::string::npos)
        << run.err;
}

} // namespace
} // namespace dirt::test
