// What `dirt dump` writes of each backend, read back from EXR files and judged: all is right, and
// equal to what the other backends make of it. And what cannot be read ends in one line.

#include "core/io/exr_parts.h"
#include "core/io/read_exr_parts.h"
#include "core/trace/traverse.h"
#include "examples/porting/write_dump.h"
#include "tests/cli/program.h"
#include "tests/support/shown_parts.h"

#include <filesystem>
#include <functional>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace dirt::test {
namespace {

/// Two walls, a floor and a block around the eye; one triangle holds it.
constexpr const char* kRoomObj = "v -2 -1 -3\nv 2 -1 -3\nv 2 2 -3\nv -2 2 -3\n"
                                 "v -2 -1 3\nv 2 -1 3\nv -0.5 -1 -2\nv 0.5 -1 -2\nv 0 0.3 -1.5\n"
                                 "v 0 0 0\nv 0.4 0.7 0.2\nv -0.3 0.5 0.9\n"
                                 "f 1 2 3 4\nf 1 5 6 2\nf 2 6 3\nf 7 8 9\nf 8 1 9\nf 10 11 12\n";

class OwnDumps : public testing::TestWithParam<std::pair<const char*, const char*>> {
protected:
    std::string backend() const { return GetParam().first; }
    std::string view() const { return GetParam().second; }

    /// False where this machine has no such backend.
    bool dump(std::vector<std::string> options = {}) {
        folder_.write("a.obj", kRoomObj);
        const std::string scene = folder_.write(
            "a.scene",
            "<world background=\"1 1 1\"><object file=\"a.obj\"/>"
            "<light type=\"spotlight\" position=\"0.8 0.2 -0.3\" target=\"0 0 -2\" flux=\"5\"/>"
            "<user position=\"0 0 0\" lookat=\"0 0 -1\"/></world>");
        options.insert(options.begin(),
                       {"dump", scene, "--quiet", "--size", "40x28", "--view", view(), "--backend",
                        backend(), "--primary", "traced", "-o", folder_ / "dump"});
        if (backend() != "embree") options.insert(options.end(), {"--tile", "8", "--bins", "6"});
        const Outcome run = dirt(options);
        EXPECT_TRUE(run.status == 0 || run.status == 3) << run.err;
        return run.status == 0;
    }

    nlohmann::json replay(std::vector<std::string> options, int status = 0) {
        options.insert(options.begin(), {"replay", folder_ / "dump", "--json", "--quiet"});
        const Outcome run = dirt(options);
        EXPECT_EQ(run.status, status) << run.err << run.out;
        EXPECT_EQ(run.err, "");
        return run.out.empty() ? nlohmann::json() : nlohmann::json::parse(run.out);
    }

    TemporaryFolder folder_;
};

TEST_P(OwnDumps, AreRight) {
    if (!dump()) GTEST_SKIP() << "no backend " << backend();
    const nlohmann::json json = replay({"--against", "cpu"});
    const bool hasGrid = backend() != "embree";
    // Depth, pyramid, lists, the eye; and three events of hits and shadow rays.
    ASSERT_EQ(json["passes"].size(), hasGrid ? 10u : 6u);
    for (const char* buffer : {"hit buffer", "shadow rays"})
        EXPECT_EQ(
            std::count_if(json["passes"].begin(), json["passes"].end(),
                          [&](const nlohmann::json& pass) { return pass["buffer"] == buffer; }),
            3);
    for (const nlohmann::json& pass : json["passes"]) {
        EXPECT_EQ(pass["compared"], pass["right"]) << pass;
        EXPECT_GT(pass["compared"].get<uint64_t>() + pass["outside"].get<uint64_t>(), 0u) << pass;
        EXPECT_TRUE(view() == "single" || pass["outside"] == 0u) << pass;
    }
    for (const nlohmann::json& row : json["against"]["rows"]) {
        EXPECT_EQ(row["different"], 0u) << row;
        EXPECT_GT(row["compared"], 0u) << row;
    }
    EXPECT_TRUE(!hasGrid || json["list_entries"] > 100u) << json;
}

INSTANTIATE_TEST_SUITE_P(Backends, OwnDumps,
                         testing::Values(std::pair("cpu", "full"), std::pair("cpu", "single"),
                                         std::pair("gl", "full"), std::pair("embree", "full"),
                                         std::pair("embree", "single")),
                         [](const auto& info) {
                             return std::string(info.param.first) + "_" + info.param.second;
                         });

class ReplayedFiles : public OwnDumps {
protected:
    /// One line with status 2.
    void expectRefusal(const std::string& says) {
        const Outcome run = dirt({"replay", folder_ / "dump"});
        EXPECT_EQ(run.status, 2) << run.out;
        EXPECT_EQ(run.err.find("dirt: " + folder_ / "dump"), 0u) << run.err;
        EXPECT_NE(run.err.find(says), std::string::npos) << run.err;
        EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    }
    void editManifest(const std::function<void(nlohmann::json&)>& edit) {
        nlohmann::json json = nlohmann::json::parse(readFile(folder_ / "dump/manifest.json"));
        edit(json);
        folder_.write("dump/manifest.json", json.dump());
    }
};

TEST_P(ReplayedFiles, ThatCannotBeReadEndInOneLine) {
    ASSERT_TRUE(dump({"--bounces", "2"}));
    const std::string hits = readFile(folder_ / "dump/hits.1.exr");
    folder_.write("dump/hits.1.exr", hits.substr(0, hits.size() / 2));
    expectRefusal("/hits.1.exr: damaged image");
    folder_.write("dump/hits.1.exr", "no image");
    expectRefusal("/hits.1.exr: is no EXR file");
    // Of another buffer, another event's size, more parts.
    folder_.write("dump/hits.1.exr", readFile(folder_ / "dump/rays.1.exr"));
    expectRefusal("/hits.1.exr: rays: has no column primitive");
    folder_.write("dump/hits.1.exr", readFile(folder_ / "dump/depth.exr"));
    expectRefusal("/hits.1.exr: +X.level0: has no column primitive");
    folder_.write("dump/hits.1.exr", hits);
    editManifest([](nlohmann::json& json) { json["size"] = {41, 28}; });
    expectRefusal("/rays.0.exr: has 1120 records, not one for each of 41x28 pixels");
    editManifest([](nlohmann::json& json) {
        json["size"] = {40, 28};
        json["triangles"] = 30;
    });
    expectRefusal("/triangles.exr: has 8 triangles, where the manifest has 30");
    editManifest([](nlohmann::json& json) {
        json["triangles"] = 8;
        for (size_t i = 0; i < json["files"].size(); ++i)
            if (json["files"][i]["file"] == "ids.csv") json["files"].erase(i);
    });
    expectRefusal("/ids.exr: lists are read from text: ids.csv");
    EXPECT_EQ(dirt(std::vector<std::string>{"replay", folder_ / "a.obj"}).status, 2);
}

TEST_P(ReplayedFiles, OfASceneWithCutOutsAreNotJudgedByTheirHits) {
    ASSERT_TRUE(dump({"--bounces", "2"}));
    editManifest([](nlohmann::json& json) { json["cut_outs"] = true; });
    const Outcome run = dirt({"replay", folder_ / "dump"});
    EXPECT_EQ(run.status, 0);
    EXPECT_EQ(run.out.find("Trace"), std::string::npos);
    EXPECT_EQ(run.out.find("Visibility"), std::string::npos);
    EXPECT_NE(run.err.find("hits and shadow rays are not judged"), std::string::npos) << run.err;
}

INSTANTIATE_TEST_SUITE_P(Cpu, ReplayedFiles, testing::Values(std::pair("cpu", "full")));

TEST_P(ReplayedFiles, OfAVisibilityThatForgetsAShadowNameItsPixel) {
    ASSERT_TRUE(dump({"--bounces", "1"}));
    std::vector<ExrPart> parts = readExrParts(folder_ / "dump/shadowrays.0.exr");
    ASSERT_EQ(parts.size(), 1u);
    ExrPart& part = parts.front();
    const auto channel = [&](const char* name) {
        for (size_t c = 0; c < part.channels.size(); ++c)
            if (part.channels[c].name == name) return c;
        return part.channels.size();
    };
    size_t pixel = 0;
    const auto value = [&](const char* name) -> uint32_t& {
        return part.values[pixel * part.channels.size() + channel(name)];
    };
    while (value("occluded.X") == 0) ++pixel;
    const uint32_t blocker = value("blocker.X");
    EXPECT_LT(blocker, 8u);
    value("occluded.X") = 0;
    writeExr(folder_ / "dump/shadowrays.0.exr", parts, {});
    const nlohmann::json json = replay({}, 1);
    EXPECT_EQ(json["verdict"], "Visibility 0 is the first pass that is wrong: pixel " +
                                   std::to_string(pixel % 40) + "," + std::to_string(pixel / 40) +
                                   " is not occluded, where triangle " + std::to_string(blocker) +
                                   " is between it and the light, at t " +
                                   json["verdict"].get<std::string>().substr(
                                       json["verdict"].get<std::string>().rfind(' ') + 1));
    EXPECT_EQ(json["passes"].back()["faults"], nlohmann::json({{"missed occlusion", 1}}));
}

TEST_P(ReplayedFiles, MayHaveChannelsOfPlainNames) {
    ASSERT_TRUE(dump({"--bounces", "2"}));
    for (const char* name : {"hits.1.exr", "shadowrays.1.exr", "depth.exr"}) {
        std::vector<ExrPart> parts = readExrParts(folder_ / "dump/" + name);
        for (ExrPart& part : parts)
            for (ExrChannel& channel : part.channels)
                for (const char* plain : {"primitive", "t", "u", "v", "view", "tile", "occluded",
                                          "tMax", "blocker", "near", "far"})
                    if (channel.name == std::string(plain) + ".X" ||
                        channel.name == std::string(plain) + ".Z")
                        channel.name = plain;
        writeExr(folder_ / "dump/" + name, parts, {});
    }
    EXPECT_EQ(replay({}, 0)["verdict"], "all is right");
    std::vector<ExrPart> parts = readExrParts(folder_ / "dump/hits.1.exr");
    parts.front().channels.back().name = "t.X"; // besides t
    writeExr(folder_ / "dump/hits.1.exr", parts, {});
    expectRefusal("/hits.1.exr: hits: has two columns 't'");
}

/// An engine that has what core makes of two triangles and four rays.
Engine exampleEngine(const GridSettings& settings) {
    FrameGeometry geometry;
    geometry.triangles = {{{1.0f, -0.9f, -0.7f}, {1.5f, 0.8f, 0.1f}, {0.6f, 0.1f, 0.5f}},
                          {{-0.7f, -0.2f, 1.0f}, {0.3f, 0.6f, 0.9f}, {0.5f, -0.8f, 0.4f}}};
    const Grid grid = buildGrid(geometry, {}, settings);
    Engine engine;
    engine.tiles = grid.views[0].columns;
    for (const Triangle& t : geometry.triangles)
        engine.triangles.push_back({t.a.x, t.a.y, t.a.z, t.b.x, t.b.y, t.b.z, t.c.x, t.c.y, t.c.z});
    for (int view = 0; view < 6; ++view)
        for (int i = 0; i < grid.views[(size_t) view].tiles(); ++i) {
            const DepthBounds& bounds = grid.bounds(view, i);
            Engine::Tile tile{bounds.near, bounds.far, {}};
            for (int bin = 0; bin < settings.bins; ++bin) {
                const auto list = grid.list(view, i, bin);
                tile.bins.emplace_back(list.begin(), list.end());
            }
            engine.views[(size_t) view].push_back(std::move(tile));
        }
    for (int i = 0; i < settings.width * settings.height; ++i) {
        const Ray ray{{0.1f * (float) i, 0.0f, 0.0f}, {0.9f, -0.1f, 0.3f * (float) (i % 5)}};
        const Hit hit = closestHit(grid, geometry, ray);
        engine.rays.push_back({ray.origin.x, ray.origin.y, ray.origin.z, ray.direction.x,
                               ray.direction.y, ray.direction.z});
        engine.hits.push_back({hit.primitive, hit.t, hit.u, hit.v});
        const Ray shadow{{0.9f, -0.1f * (float) i, 0.0f}, {-1.0f, 0.2f, 0.5f * (float) (i % 3)}};
        engine.shadowRays.push_back({shadow.origin.x, shadow.origin.y, shadow.origin.z,
                                     shadow.direction.x, shadow.direction.y, shadow.direction.z,
                                     1.0f});
        engine.occluded.push_back(anyHit(grid, geometry, shadow, 1.0f));
    }
    return engine;
}

TEST(PortingPage, ShowsCodeThatWritesADumpWhichReplays) {
    const std::string code = markedParts(sourceFile("examples/porting/write_dump.h")).at("write");
    EXPECT_LE(std::count(code.begin(), code.end(), '\n'), 40);
    const auto shown = shownParts(sourceFile("docs/porting.md"));
    EXPECT_EQ(shown.at("write"), code);

    const nlohmann::json manifest = nlohmann::json::parse(shown.at("manifest"));
    GridSettings settings;
    settings.width = manifest["size"][0];
    settings.height = manifest["size"][1];
    settings.tile = manifest["tile"];
    settings.bins = manifest["bins"];
    settings.viewSize = manifest["view_frames"][0]["size"][0];
    const TemporaryFolder folder;
    folder.write("manifest.json", shown.at("manifest"));
    Engine engine = exampleEngine(settings);
    writeDump(engine, folder.path());
    Outcome run = dirt({"replay", folder.path()});
    EXPECT_EQ(run.status, 0) << run.out;
    EXPECT_EQ(run.err, "");

    // And what the page shows of an answer is what is said of such a fault.
    engine.views[0][5].bins[3].clear();
    writeDump(engine, folder.path());
    run = dirt({"replay", folder.path()});
    EXPECT_EQ(run.status, 1);
    EXPECT_EQ(run.out, shown.at("answer"));
}

} // namespace
} // namespace dirt::test
