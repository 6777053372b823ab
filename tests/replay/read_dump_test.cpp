// How `dirt replay` reads the dumps of other engines: what forms they may have, and where it
// refuses one.

#include "tests/replay/replay_fixture.h"

namespace dirt::test {
namespace {

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

} // namespace
} // namespace dirt::test
