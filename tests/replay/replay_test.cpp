// `dirt replay` judges dumps that an independent script wrote by rational arithmetic: the right
// one, and others with one fault each, which it has to name in its pass and place.

#include "tests/replay/replay_fixture.h"

namespace dirt::test {
namespace {

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
