// `dirt dump`: the manifest describes the files that are there, and what cannot be dumped ends in
// one line.

#include "tests/cli/program.h"

#include <algorithm>
#include <bit>
#include <map>
#include <set>

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/stat.h>

namespace dirt::test {
namespace {

using nlohmann::json;

std::vector<std::string> dumpOf(const TemporaryFolder& folder, const std::string& to,
                                std::vector<std::string> options) {
    folder.write("a.obj", kTriangleObj);
    const std::string scene = folder.write(
        "a.scene", "<world background=\"1 1 1\"><object file=\"a.obj\"/>"
                   "<light type=\"spotlight\" position=\"0 1 0\" target=\"0 0 -2\" flux=\"5\"/>"
                   "<user position=\"0 0 0\" lookat=\"0 0 -1\"/></world>");
    options.insert(options.begin(), {"dump", scene, "--quiet", "--size", "20x10", "-o", to});
    return options;
}

std::set<std::string> filesIn(const std::string& folder) {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        names.insert(entry.path().filename().string());
    return names;
}

TEST(DumpCommand, TheManifestDescribesTheFiles) {
    const TemporaryFolder folder;
    const std::string to = folder / "dump";
    const Outcome run = dirt(dumpOf(folder, to, {"--primary", "traced", "--json"}));
    ASSERT_EQ(run.status, 0) << run.err;
    const json manifest = json::parse(readFile(to + "/manifest.json"));
    EXPECT_EQ(json::parse(run.out), manifest);
    std::set<std::string> named{"manifest.json"};
    for (const json& file : manifest["files"]) {
        const std::string name = file["file"];
        named.insert(name);
        if (name == "ids.csv") {
            std::string header;
            for (const json& column : file["channels"])
                header += (header.empty() ? "" : ",") + column["name"].get<std::string>();
            EXPECT_EQ(readFile(to + "/" + name).substr(0, header.size() + 1), header + "\n");
            continue;
        }
        const auto input = OIIO::ImageInput::open(to + "/" + name);
        ASSERT_TRUE(input) << name;
        for (size_t part = 0; part < file["parts"].size(); ++part) {
            ASSERT_TRUE(input->seek_subimage((int) part, 0)) << name;
            const OIIO::ImageSpec& spec = input->spec();
            EXPECT_EQ(spec["oiio:subimagename"].get(), file["parts"][part].get<std::string>());
            EXPECT_EQ((size_t) spec.nchannels, file["channels"].size()) << name;
            for (const json& channel : file["channels"]) {
                const int index = spec.channelindex(channel["name"].get<std::string>());
                ASSERT_GE(index, 0) << name << " " << channel;
                EXPECT_EQ(spec.channelformat(index), channel["type"] == "uint32"
                                                         ? OIIO::TypeDesc::UINT
                                                         : OIIO::TypeDesc::FLOAT);
                EXPECT_FALSE(channel["meaning"].get<std::string>().empty());
            }
        }
        EXPECT_FALSE(input->seek_subimage((int) file["parts"].size(), 0)) << name;
    }
    EXPECT_EQ(filesIn(to), named);
    for (const char* name : {"triangles.exr", "depth.exr", "ids.exr", "ids.csv", "direct.exr",
                             "rays.0.exr", "hits.2.exr", "mask.1.exr", "visibility.0.exr",
                             "shadowrays.2.exr", "shading.2.exr", "image.2.exr"})
        EXPECT_TRUE(named.contains(name)) << name;
    EXPECT_EQ(manifest["view_frames"].size(), 6u);
    EXPECT_EQ(manifest["fov"], 45.0);
    EXPECT_EQ(manifest["cut_outs"], false);
}

TEST(DumpCommand, WritesWhatIsAskedFor) {
    const TemporaryFolder folder;
    ASSERT_EQ(dirt(dumpOf(folder, folder / "a", {"--buffers", "ids,hits", "--event", "1"})).status,
              0);
    EXPECT_EQ(filesIn(folder / "a"),
              (std::set<std::string>{"ids.exr", "ids.csv", "hits.1.exr", "manifest.json"}));
    ASSERT_EQ(dirt(dumpOf(folder, folder / "b", {"--buffers", "direct", "--event", "2"})).status,
              0);
    EXPECT_EQ(filesIn(folder / "b"), (std::set<std::string>{"direct.exr", "manifest.json"}));
    ASSERT_EQ(dirt(dumpOf(folder, folder / "c", {"--view", "single", "--bounces", "1"})).status, 0);
    EXPECT_EQ(filesIn(folder / "c"),
              (std::set<std::string>{"triangles.exr", "depth.exr", "ids.exr", "ids.csv",
                                     "direct.exr", "shadowrays.0.exr", "visibility.0.exr",
                                     "shading.0.exr", "image.0.exr", "manifest.json"}));
}

/// The channels of a file, by name.
std::map<std::string, std::vector<uint32_t>> channelsOf(const std::string& file) {
    std::map<std::string, std::vector<uint32_t>> values;
    const auto input = OIIO::ImageInput::open(file);
    EXPECT_TRUE(input) << file;
    if (!input) return values;
    const OIIO::ImageSpec& spec = input->spec();
    for (int c = 0; c < spec.nchannels; ++c) {
        auto& channel = values[spec.channelnames[c]];
        channel.resize((size_t) spec.width * (size_t) spec.height);
        EXPECT_TRUE(input->read_image(0, 0, c, c + 1, spec.channelformat(c), channel.data()));
    }
    return values;
}

TEST(DumpCommand, TheSamplesAreThoseOfARender) {
    const TemporaryFolder folder;
    const std::string scene = DIRT_SOURCE_DIR "/scenes/cornell.scene";
    const auto run = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.begin() + 1, {scene, "--quiet", "--size", "32x24"});
        EXPECT_EQ(dirt(arguments).status, 0);
    };
    run({"render", "--spp", "3", "-o", folder / "three.exr"});
    std::vector<float> sum(32 * 24, 0.0f);
    std::set<std::vector<uint32_t>> different;
    for (const char* sample : {"0", "1", "2"}) {
        const std::string to = folder / sample;
        run({"dump", "--buffers", "image,rays", "--sample", sample, "-o", to});
        EXPECT_EQ(json::parse(readFile(to + "/manifest.json"))["sample"].dump(), sample);
        const auto green = channelsOf(to + "/image.2.exr").at("G");
        for (size_t i = 0; i < sum.size(); ++i) sum[i] += std::bit_cast<float>(green[i]);
        different.insert(green);
    }
    EXPECT_EQ(different.size(), 3u);
    const auto mean = channelsOf(folder / "three.exr").at("G");
    for (size_t i = 0; i < sum.size(); ++i)
        EXPECT_EQ(sum[i] * (1.0f / 3.0f), std::bit_cast<float>(mean[i])) << i;
}

TEST(DumpCommand, TheBackendsHaveTheSameShadowRays) {
    const TemporaryFolder folder;
    const std::string scene = DIRT_SOURCE_DIR "/scenes/cornell.scene";
    std::map<std::string, std::map<std::string, std::vector<uint32_t>>> found;
    for (const char* backend : {"cpu", "gl", "embree"}) {
        std::vector<std::string> arguments = {
            "dump",      scene,    "--quiet",   "--size",     "48x32", "--backend",     backend,
            "--primary", "traced", "--buffers", "shadowrays", "-o",    folder / backend};
        if (backend != std::string("embree"))
            arguments.insert(arguments.end(), {"--tile", "8", "--bins", "6"});
        const Outcome run = dirt(arguments);
        if (run.status == 3) continue; // there is none
        ASSERT_EQ(run.status, 0) << run.err;
        for (const char* event : {"0", "1", "2"})
            for (auto& [name, values] :
                 channelsOf(folder / backend + "/shadowrays." + event + ".exr"))
                found[backend][name + " " + event] = std::move(values);
    }
    const auto& cpu = found["cpu"];
    ASSERT_EQ(cpu.size(), 3u * 14u);
    const auto& occluded = cpu.at("occluded.X 0");
    EXPECT_GT(std::count(occluded.begin(), occluded.end(), 1u), 50);
    EXPECT_GT(std::count(occluded.begin(), occluded.end(), 0u), 50);
    for (const auto& [backend, channels] : found)
        for (const auto& [name, values] : channels) {
            const bool isPlace =
                name.starts_with("view") || name.starts_with("column") || name.starts_with("row");
            if (isPlace && backend == "embree") // which has no tiles
                EXPECT_EQ(values, std::vector<uint32_t>(values.size(), 0)) << name;
            else
                EXPECT_EQ(values, cpu.at(name)) << backend << " " << name;
        }
}

TEST(DumpCommand, ReplacesAnEarlierDump) {
    const TemporaryFolder folder;
    const std::string to = folder / "a";
    ASSERT_EQ(dirt(dumpOf(folder, to, {"--primary", "traced"})).status, 0);
    folder.write("a/mine.exr", "not the dump's");
    ASSERT_EQ(dirt(dumpOf(folder, to, {"--buffers", "visibility", "--bounces", "1"})).status, 0);
    const json manifest = json::parse(readFile(to + "/manifest.json"));
    ASSERT_EQ(manifest["files"].size(), 1u);
    EXPECT_EQ(manifest["files"][0]["file"], "visibility.0.exr");
    // What the earlier one wrote besides stays, like all else.
    EXPECT_EQ(readFile(folder / "a/mine.exr"), "not the dump's");
    EXPECT_TRUE(filesIn(to).contains("image.2.exr"));
}

TEST(DumpCommand, LeavesOthersFilesAlone) {
    const TemporaryFolder folder;
    folder.write("a/mine.exr", "mine");
    const auto refused = [&](const std::string& manifest) {
        const Outcome run = dirt(dumpOf(folder, folder / "a", {}));
        EXPECT_EQ(run.status, 2);
        EXPECT_NE(run.err.find("manifest.json: cannot write"), std::string::npos) << run.err;
        EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
        EXPECT_EQ(filesIn(folder / "a"), (std::set<std::string>{"mine.exr", "manifest.json"}));
        if (manifest.empty()) return;
        EXPECT_EQ(readFile(folder / "a/manifest.json"), manifest);
    };
    for (const char* manifest :
         {"{\"files\": [{\"file\": \"mine.exr\"}]}", "{\"name\": \"an app\"}", "[]", "no JSON", "{",
          "{\"backend\": \"cpu\", \"files\": [{\"file\": \"mine.exr\"}]}",
          "{\"backend\": 1, \"files\": []}", "{\"backend\": \"cpu\", \"files\": {}}",
          "{\"backend\": \"cpu\", \"files\": [{\"file\": \"mine.exr\", \"buffer\": \"ids\"}]}",
          "{\"backend\": \"cpu\", \"files\": [{\"file\": \"ids.1.exr\", \"buffer\": \"ids\"}]}",
          "{\"backend\": \"cpu\", \"files\": [{\"file\": \"../a.exr\", \"buffer\": \"../a\"}]}",
          "{\"backend\": \"cpu\", \"files\": [{\"file\": \"ids.-1.exr\", \"buffer\": \"ids\", "
          "\"event\": -1}]}"}) {
        folder.write("a/manifest.json", manifest);
        refused(manifest);
    }
    const std::string large = std::string(8'000'000, '[');
    folder.write("a/manifest.json", large);
    const Outcome dear = dirt(dumpOf(folder, folder / "a", {"--memory", "100M"}));
    EXPECT_EQ(dear.status, 2);
    EXPECT_NE(dear.err.find("manifest.json: its JSON needs "), std::string::npos) << dear.err;
    EXPECT_EQ(readFile(folder / "a/manifest.json"), large);
    std::filesystem::remove(folder / "a/manifest.json");
    mkfifo((folder / "a/manifest.json").c_str(), 0600); // which nobody writes to
    refused("");
    std::filesystem::remove(folder / "a/manifest.json");
    mkfifo((folder / "a/hits.1.exr").c_str(), 0600);
    const Outcome run = dirt(dumpOf(folder, folder / "a", {}));
    EXPECT_EQ(run.status, 2);
    EXPECT_NE(run.err.find("hits.1.exr: cannot write: not a regular file"), std::string::npos);
    EXPECT_EQ(filesIn(folder / "a"), (std::set<std::string>{"mine.exr", "hits.1.exr"}));
}

TEST(DumpCommand, SaysWhatAFrameDoesNotHave) {
    const TemporaryFolder folder;
    auto arguments =
        dumpOf(folder, folder / "a", {"--buffers", "shadowmap,ids,mask", "--bounces", "1"});
    std::erase(arguments, "--quiet");
    const Outcome run = dirt(arguments);
    EXPECT_EQ(run.status, 0);
    EXPECT_EQ(run.err.find("dirt: warning: --buffers shadowmap,mask: this frame has none\n"), 0u)
        << run.err;
    const Outcome all = dirt(dumpOf(folder, folder / "b", {}));
    EXPECT_EQ(all.err.find("warning"), std::string::npos) << all.err;
}

TEST(DumpCommand, EndsInOneLine) {
    const TemporaryFolder folder;
    const auto fails = [&](const std::string& to, const std::vector<std::string>& options,
                           const char* what) {
        const Outcome run = dirt(dumpOf(folder, to, options));
        EXPECT_EQ(run.status, 2);
        EXPECT_NE(run.err.find(what), std::string::npos) << run.err;
        EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    };
    fails(folder / "a", {"--buffers", "depth,colour"}, "colour");
    fails(folder / "a", {"--event", "3"}, "--event 3");
    fails(folder / "a", {"--size", "65536x65536"}, "memory");
    fails(folder / "a", {"--spp", "2"}, "--spp");
    fails(folder / "none/a", {}, "none/a");
    fails(folder.write("file", "text"), {}, "file");
    EXPECT_FALSE(std::filesystem::exists(folder / "a"));
    EXPECT_EQ(readFile(folder / "file"), "text");
}

#ifdef DIRT_HAVE_EMBREE
TEST(DumpCommand, EmbreeHasNoGridButTheSameHits) {
    const TemporaryFolder folder;
    const std::string scene = DIRT_SOURCE_DIR "/scenes/cornell.scene";
    for (const char* backend : {"cpu", "embree"})
        ASSERT_EQ(dirt({"dump", scene, "--quiet", "--size", "48x32", "--backend", backend,
                        "--buffers", "depth,ids,rays,hits,shading", "-o", folder / backend})
                      .status,
                  0);
    EXPECT_TRUE(filesIn(folder / "cpu").contains("ids.exr"));
    EXPECT_FALSE(filesIn(folder / "embree").contains("ids.exr"));
    const auto channels = [&](const std::string& file) { return channelsOf(folder / file); };
    for (const char* file : {"shading.0.exr", "rays.1.exr", "hits.1.exr", "shading.2.exr"}) {
        auto ours = channels(std::string("cpu/") + file);
        auto theirs = channels(std::string("embree/") + file);
        for (const char* place : {"view.X", "tile.X"}) { // which Embree has not
            ours.erase(place);
            theirs.erase(place);
        }
        EXPECT_EQ(ours, theirs) << file;
        EXPECT_GT(ours.size(), 4u);
    }
    size_t found = 0;
    const auto hits = channels("cpu/hits.1.exr");
    for (uint32_t primitive : hits.at("primitive.X")) found += primitive < 36;
    EXPECT_GT(found, 500u);
}
#endif

} // namespace
} // namespace dirt::test
