// Dumped buffers, read back with OpenImageIO: the bits of the buffers.

#include "core/dump/dump.h"

#include "backend_cpu/cpu_backend.h"
#include "backend_cpu/thread_pool.h"
#include "core/base/error.h"
#include "core/dump/entries.h"
#include "core/frame/renderer.h"
#include "tests/cli/program.h"
#include "tests/frame/shapes.h"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <map>
#include <regex>
#include <set>
#include <tuple>

#include <OpenImageIO/deepdata.h>
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

namespace dirt {
namespace {

/// One part as the file has it: the bits of each channel by name.
struct Part {
    int width = 0, height = 0;
    std::map<std::string, std::vector<uint32_t>> channels;
    std::map<std::string, OIIO::TypeDesc> types;
};

std::map<std::string, Part> readParts(const std::string& path) {
    const auto input = OIIO::ImageInput::open(path);
    EXPECT_TRUE(input) << OIIO::geterror();
    std::map<std::string, Part> parts;
    for (int index = 0; input && input->seek_subimage(index, 0); ++index) {
        const OIIO::ImageSpec spec = input->spec(index);
        Part& part = parts[spec["oiio:subimagename"].get()];
        part.width = spec.width;
        part.height = spec.height;
        const size_t pixels = (size_t) spec.width * spec.height;
        std::vector<uint32_t> values(pixels * spec.nchannels);
        EXPECT_TRUE(
            input->read_image(index, 0, 0, spec.nchannels, OIIO::TypeDesc::UNKNOWN, values.data()));
        for (int c = 0; c < spec.nchannels; ++c) {
            part.types[spec.channelnames[c]] = spec.channelformat(c);
            for (size_t i = 0; i < pixels; ++i)
                part.channels[spec.channelnames[c]].push_back(values[i * spec.nchannels + c]);
        }
    }
    return parts;
}

template <typename Record>
uint32_t wordOf(const Record& record, size_t offset) {
    uint32_t word;
    std::memcpy(&word, (const char*) &record + offset, sizeof word);
    return word;
}

/// Every channel of \p infos holds the bits that the records have at its offset.
template <typename Record>
void expectRecords(const Part& part, const std::vector<ChannelInfo>& infos,
                   const std::vector<Record>& records) {
    for (const ChannelInfo& info : infos) {
        const std::string& name = info.inFile;
        ASSERT_TRUE(part.channels.contains(name)) << name;
        EXPECT_EQ(part.types.at(name), info.channel.type == ExrChannel::Type::uint32
                                           ? OIIO::TypeDesc::UINT
                                           : OIIO::TypeDesc::FLOAT)
            << name;
        const auto& values = part.channels.at(name);
        ASSERT_GE(values.size(), records.size());
        for (size_t i = 0; i < records.size(); ++i)
            ASSERT_EQ(values[i], wordOf(records[i], info.offset)) << name << ", record " << i;
    }
}

/// Every four bytes of a record but those named unused are in one channel.
void expectAllBytes(const std::vector<ChannelInfo>& infos, size_t size, size_t unused) {
    std::set<size_t> offsets;
    for (const ChannelInfo& info : infos) EXPECT_TRUE(offsets.insert(info.offset).second);
    EXPECT_EQ(offsets.size() + unused, size / 4);
    for (const ChannelInfo& info : infos) EXPECT_FALSE(info.meaning.empty());
}

class DumpTest : public testing::TestWithParam<ViewMode> {
protected:
    test::TemporaryFolder folder_;
    SerialExecutor serial_;
    CpuBackend backend_{serial_};
    Scene scene_ = test::room();
    RenderSettings settings_;

    void SetUp() override {
        settings_.grid.mode = GetParam();
        settings_.grid.width = 45;
        settings_.grid.height = 31;
        settings_.grid.tile = 4;
        settings_.grid.bins = 5;
        settings_.samples = 1;
    }
    std::map<std::string, Part> read(const std::string& name) { return readParts(folder_ / name); }
};

} // namespace

TEST_P(DumpTest, HoldsTheShadowMapWhereThereIsOne) {
    Dump dump(folder_.path(), 45, 31, {});
    settings_.visibility = LightVisibility::shadowMap;
    scene_.lights[0].resolution = 37;
    Renderer(scene_, settings_, backend_).render();
    const std::vector<float> depths = backend_.readShadowMap();
    ASSERT_EQ(depths.size(), 37u * 37u);
    dump.shadowMap(depths);
    const Part part = read("shadowmap.exr")["shadowmap"];
    EXPECT_EQ(part.width, 37);
    EXPECT_EQ(part.height, 37);
    expectRecords(part, shadowMapChannels(), depths);

    dump.shadowMap({});
    EXPECT_EQ(dump.files().size(), 1u);
}

TEST(DumpChannels, NameEveryByte) {
    expectAllBytes(triangleChannels(), sizeof(Triangle), 0);
    expectAllBytes(depthChannels(), sizeof(DepthBounds), 0);
    expectAllBytes(rayChannels(), sizeof(PathRay), 1);
    expectAllBytes(shadowRayChannels(), sizeof(ShadowRecord), 0);
    expectAllBytes(hitChannels(), sizeof(Hit), 0);
    expectAllBytes(surfacePointChannels(), sizeof(SurfacePoint), 0);
    expectAllBytes(entryChannels(), sizeof(ListEntry), 0);
}

TEST(DumpChannels, AreLayersThatCompositorsKeep) {
    // Blender keeps a channel whose name ends in one of a few letters, after at most a pass and a
    // layer; Nuke letters, digits and underscores, dots between layers made into one. OpenEXR 1 has
    // names of 31 characters.
    const std::regex name("(?:[A-Za-z][A-Za-z0-9]*\\.){0,2}[RGBXYZ]");
    for (auto channels : {triangleChannels(), depthChannels(), shadowMapChannels(), rayChannels(),
                          shadowRayChannels(), hitChannels(), surfacePointChannels(),
                          flagChannels("alive", ""), flagChannels("visible", ""),
                          radianceChannels(), withPrefix("previous", surfacePointChannels())}) {
        std::set<std::string> flattened;
        for (const ChannelInfo& info : channels) {
            EXPECT_TRUE(std::regex_match(info.inFile, name)) << info.inFile;
            EXPECT_LE(info.inFile.size(), 31u) << info.inFile;
            std::string flat = info.inFile;
            for (char& c : flat) c = c == '.' ? '_' : (char) std::tolower((unsigned char) c);
            EXPECT_TRUE(flattened.insert(flat).second) << info.inFile;
        }
    }
    // Deep files have the names that compositors give meaning to.
    for (const ChannelInfo& info : entryChannels()) EXPECT_EQ(info.inFile, info.channel.name);
}

TEST_P(DumpTest, HoldsTheBitsOfEveryBuffer) {
    Dump dump(folder_.path(), 45, 31, {{"dirt:scene", "room"}});
    int events = 0;
    RenderHooks hooks;
    hooks.observe = [&](uint32_t, int k) {
        ++events;
        const PathBuffers paths = backend_.readPaths();
        const std::string end = "." + std::to_string(k) + ".exr";
        if (k == 0) {
            dump.direct(paths);
            expectRecords(read("direct.exr")["direct"], surfacePointChannels(), paths.next);
        }
        dump.rays(paths, k);
        expectRecords(read("rays" + end)["rays"], rayChannels(), paths.rays);
        dump.hits(paths, k);
        expectRecords(read("hits" + end)["hits"], hitChannels(), paths.hits);
        dump.shading(paths, k);
        const Part shading = read("shading" + end)["shading"];
        EXPECT_EQ(shading.width, 45);
        EXPECT_EQ(shading.height, 31);
        expectRecords(shading, withPrefix("previous", surfacePointChannels()), paths.previous);
        expectRecords(shading, withPrefix("current", surfacePointChannels()), paths.current);
        expectRecords(shading, withPrefix("next", surfacePointChannels()), paths.next);
        dump.image(paths, k);
        expectRecords(read("image" + end)["image"], radianceChannels(), paths.radiance);
        dump.mask(paths, k);
        expectRecords(read("mask" + end)["mask"], flagChannels("alive", ""),
                      std::vector<uint32_t>(paths.mask.begin(), paths.mask.end()));
        const FrameGeometry geometry = backend_.readGeometry();
        const FrameContext frame(scene_, geometry, settings_,
                                 requirementsOf(scene_, settings_, backend_.rasterizes()));
        const std::vector<ShadowRecord> shadows = shadowRecordsOf(frame, backend_, k, paths);
        dump.shadowRays(shadows, k);
        expectRecords(read("shadowrays" + end)["shadowrays"], shadowRayChannels(), shadows);
        dump.visibility(paths, k);
        expectRecords(read("visibility" + end)["visibility"], flagChannels("visible", ""),
                      std::vector<uint32_t>(paths.visibility.begin(), paths.visibility.end()));
    };
    Renderer renderer(scene_, settings_, backend_);
    renderer.keepPreviousPoint();
    renderer.render(hooks);
    EXPECT_EQ(events, 3);
    EXPECT_EQ(dump.files().size(), 1u + 3u * 7u);
}

TEST_P(DumpTest, HoldsTheStructure) {
    backend_.build(scene_.mesh, scene_.camera, settings_.grid);
    const Grid& grid = backend_.grid();
    Dump dump(folder_.path(), 45, 31, {});
    dump.triangles(backend_.geometry());
    expectRecords(read("triangles.exr")["triangles"], triangleChannels(),
                  backend_.geometry().triangles);
    dump.depth(grid);
    auto depth = read("depth.exr");
    size_t parts = 0;
    for (size_t view = 0; view < grid.views.size(); ++view)
        for (size_t level = 0; level < grid.pyramids[view].levels.size(); ++level, ++parts) {
            const auto& expected = grid.pyramids[view].levels[level];
            const Part& part = depth[viewName(grid, view) + ".level" + std::to_string(level)];
            EXPECT_EQ(part.width, expected.columns);
            EXPECT_EQ(part.height, expected.rows);
            expectRecords(part, depthChannels(), expected.bounds);
        }
    EXPECT_EQ(depth.size(), parts);
}

TEST_P(DumpTest, HoldsEveryListEntryAsADeepSample) {
    backend_.build(scene_.mesh, scene_.camera, settings_.grid);
    const Grid& grid = backend_.grid();
    Dump dump(folder_.path(), 45, 31, {});
    dump.ids(grid, backend_.geometry());

    const auto input = OIIO::ImageInput::open(folder_ / "ids.exr");
    ASSERT_TRUE(input);
    size_t samples = 0;
    for (size_t view = 0; view < grid.views.size(); ++view) {
        OIIO::DeepData data;
        ASSERT_TRUE(input->read_native_deep_image((int) view, 0, data));
        const OIIO::ImageSpec spec = input->spec((int) view);
        EXPECT_EQ(spec["oiio:subimagename"].get(), viewName(grid, view));
        const auto channel = [&](const char* name) { return spec.channelindex(name); };
        ASSERT_EQ(data.pixels(), grid.views[view].tiles());
        for (int tile = 0; tile < grid.views[view].tiles(); ++tile) {
            std::vector<std::vector<uint32_t>> lists((size_t) settings_.grid.bins);
            std::tuple<uint32_t, float, uint32_t> last{0, -1.0f, 0};
            for (int s = 0; s < data.samples(tile); ++s, ++samples) {
                const uint32_t id = data.deep_value_uint(tile, channel("id"), s);
                const uint32_t bin = data.deep_value_uint(tile, channel("bin"), s);
                EXPECT_EQ(data.deep_value_uint(tile, channel("view"), s), view);
                const float z = data.deep_value(tile, channel("Z"), s);
                const float back = data.deep_value(tile, channel("ZBack"), s);
                ASSERT_LT(bin, lists.size());
                lists[bin].push_back(id);
                const DepthBounds& bounds = grid.bounds((int) view, tile);
                EXPECT_TRUE(bounds.near <= z && z <= back && back <= bounds.far);
                const BinMap map(bounds, settings_.grid.bins);
                EXPECT_TRUE(map(z) <= (int) bin && (int) bin <= map(back));
                const std::tuple<uint32_t, float, uint32_t> order{bin, z, id};
                EXPECT_LT(last, order);
                last = order;
            }
            for (int bin = 0; bin < settings_.grid.bins; ++bin) {
                std::sort(lists[bin].begin(), lists[bin].end());
                const auto expected = grid.list((int) view, tile, bin);
                EXPECT_EQ(lists[bin], std::vector<uint32_t>(expected.begin(), expected.end()));
            }
        }
    }
    EXPECT_EQ(samples, grid.ids.size());
    EXPECT_GT(samples, 1000u);
}

TEST_P(DumpTest, HoldsEveryListEntryInALineOfText) {
    backend_.build(scene_.mesh, scene_.camera, settings_.grid);
    const Grid& grid = backend_.grid();
    Dump dump(folder_.path(), 45, 31, {});
    dump.ids(grid, backend_.geometry());
    std::string expected = "view,column,row,bin,id\n";
    for (int view = 0; view < (int) grid.views.size(); ++view)
        for (int row = 0; row < grid.views[(size_t) view].rows; ++row)
            for (int column = 0; column < grid.views[(size_t) view].columns; ++column)
                for (int bin = 0; bin < settings_.grid.bins; ++bin)
                    for (const uint32_t id :
                         grid.list(view, row * grid.views[(size_t) view].columns + column, bin))
                        expected += std::to_string(view) + "," + std::to_string(column) + "," +
                                    std::to_string(row) + "," + std::to_string(bin) + "," +
                                    std::to_string(id) + "\n";
    EXPECT_EQ(test::readFile(folder_ / "ids.csv"), expected);
}

TEST_P(DumpTest, EqualFramesAreEqualFiles) {
    const char* const files[] = {"triangles.exr", "depth.exr", "ids.exr", "ids.csv",
                                 "shading.1.exr"};
    std::map<std::string, std::string> first;
    for (unsigned threads : {1u, 3u}) {
        ThreadPool pool(threads);
        CpuBackend backend(pool);
        Dump dump(folder_.path(), 45, 31, {});
        RenderHooks hooks;
        hooks.observe = [&](uint32_t, int event) {
            if (event == 1) dump.shading(backend.readPaths(), event);
        };
        Renderer(scene_, settings_, backend).render(hooks);
        dump.triangles(backend.geometry());
        dump.depth(backend.grid());
        dump.ids(backend.grid(), backend.geometry());
        for (const char* file : files) {
            const std::string bytes = test::readFile(folder_ / file);
            if (threads == 1) first[file] = bytes;
            EXPECT_EQ(bytes, first[file]) << file;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Modes, DumpTest, testing::Values(ViewMode::full, ViewMode::single),
                         [](const auto& info) {
                             return info.param == ViewMode::full ? "Full" : "Single";
                         });

} // namespace dirt
