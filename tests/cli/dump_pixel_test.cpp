// `dirt dump --pixel`: the numbers of one pixel are those of the buffers, its tiles' lists those of
// ids.csv, on every backend.

#include "tests/cli/program.h"

#include <bit>
#include <map>
#include <set>
#include <sstream>

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace dirt::test {
namespace {

using nlohmann::json;

constexpr int kWidth = 40, kHeight = 28;

/// Of one file, the bits of each channel at one pixel.
std::map<std::string, uint32_t> valuesAt(const std::string& file, int x, int y) {
    std::map<std::string, uint32_t> values;
    const auto input = OIIO::ImageInput::open(file);
    EXPECT_TRUE(input) << file;
    for (int c = 0; input && c < input->spec().nchannels; ++c) {
        std::vector<uint32_t> channel(kWidth * kHeight);
        EXPECT_TRUE(
            input->read_image(0, 0, c, c + 1, input->spec().channelformat(c), channel.data()));
        values[input->spec().channelnames[c]] = channel[(size_t) (y * kWidth + x)];
    }
    return values;
}

/// The entries of \p record are the values of the channels that begin with \p prefix: a number is
/// channel X of its layer, an array X, Y, Z or R, G, B.
void expectRecord(const json& record, const std::map<std::string, uint32_t>& values,
                  const std::string& prefix = "") {
    size_t used = 0, due = 0;
    const auto expect = [&](const json& value, const std::string& channel) {
        ASSERT_TRUE(values.contains(channel)) << channel;
        const uint32_t bits = values.at(channel);
        EXPECT_TRUE(value.is_number_float()
                        ? (float) value.get<double>() == std::bit_cast<float>(bits)
                        : value == bits)
            << channel << " is " << value;
        ++used;
    };
    for (const auto& [name, value] : record.items()) {
        if (!value.is_array()) {
            expect(value, prefix + name + ".X");
            continue;
        }
        const std::string letters = values.contains(prefix + name + ".R") ? "RGB" : "XYZ";
        ASSERT_EQ(value.size(), 3u);
        for (size_t i = 0; i < 3; ++i) expect(value[i], prefix + name + "." + letters[i]);
    }
    for (const auto& [name, bits] : values) due += name.starts_with(prefix);
    EXPECT_EQ(used, due);
}

class DumpedPixel : public testing::TestWithParam<const char*> {
protected:
    TemporaryFolder folder_;
    std::string scene_ = DIRT_SOURCE_DIR "/scenes/cornell.scene";

    Outcome dump(std::vector<std::string> options) {
        options.insert(options.begin(), {"dump", scene_, "--quiet", "--size", "40x28", "--backend",
                                         GetParam(), "--sample", "1"});
        if (GetParam() != std::string("embree"))
            options.insert(options.end(), {"--tile", "8", "--bins", "6"});
        return dirt(options);
    }
    json pixel(int x, int y, const std::vector<std::string>& more = {}) {
        std::vector<std::string> options = {"--pixel", std::to_string(x) + "," + std::to_string(y),
                                            "-o", folder_ / "pixel.json"};
        options.insert(options.end(), more.begin(), more.end());
        const Outcome run = dump(options);
        EXPECT_EQ(run.status, 0) << run.err;
        return json::parse(readFile(folder_ / "pixel.json"));
    }

    /// Of each (view, column, row, bin) its ids, from ids.csv.
    std::map<std::array<int, 4>, std::set<uint32_t>> lists() const {
        std::map<std::array<int, 4>, std::set<uint32_t>> lists;
        std::istringstream text(readFile(folder_ / "dump/ids.csv"));
        std::string line;
        std::getline(text, line);
        while (std::getline(text, line)) {
            std::array<int, 4> at;
            unsigned id;
            EXPECT_EQ(
                std::sscanf(line.c_str(), "%d,%d,%d,%d,%u", &at[0], &at[1], &at[2], &at[3], &id),
                5);
            lists[at].insert(id);
        }
        return lists;
    }
};

TEST_P(DumpedPixel, HasTheNumbersOfTheBuffers) {
    const Outcome run = dump({"--primary", "traced", "-o", folder_ / "dump"});
    if (run.status == 3) GTEST_SKIP() << "no backend " << GetParam();
    ASSERT_EQ(run.status, 0) << run.err;
    const bool hasGrid = GetParam() != std::string("embree");
    const auto lists = hasGrid ? this->lists() : decltype(this->lists())();
    size_t events = 0, shadows = 0, ends = 0, entries = 0;
    for (const auto& [x, y] : {std::pair(3, 5), {20, 14}, {28, 20}, {12, 22}, {39, 27}}) {
        const json found = pixel(x, y, {"--primary", "traced"});
        EXPECT_EQ(found["pixel"], json({x, y}));
        EXPECT_EQ(found["sample"], 1);
        ends += found["events"].size() < 3;
        for (const json& event : found["events"]) {
            SCOPED_TRACE(event["event"]);
            const std::string end = "." + event["event"].dump() + ".exr";
            const auto values = [&, x = x, y = y](const std::string& buffer) {
                return valuesAt(folder_ / "dump/" + buffer + end, x, y);
            };
            EXPECT_EQ(event["rasterized"], false);
            expectRecord(event["rays"], values("rays"));
            expectRecord(event["hits"], values("hits"));
            const auto shading = values("shading");
            EXPECT_EQ(event["point"].is_null(), shading.at("next.primitive.X") == 4294967295u);
            if (!event["point"].is_null()) expectRecord(event["point"], shading, "next.");
            const auto shadow = values("shadowrays");
            const bool none = shadow.at("direction.X") == 0 && shadow.at("direction.Y") == 0 &&
                              shadow.at("direction.Z") == 0;
            EXPECT_EQ(event["shadowrays"].is_null(), none);
            if (!none) expectRecord(event["shadowrays"], shadow);
            const auto image = values("image");
            for (size_t c = 0; c < 3; ++c)
                EXPECT_EQ(event["image"][c].get<float>(),
                          std::bit_cast<float>(image.at(std::string(1, "RGB"[c]))));
            ++events;
            shadows += !none;
            EXPECT_EQ(event["tiles"].is_null(), !hasGrid);
            if (!hasGrid) continue;
            std::set<uint32_t> seen;
            for (const char* ray : {"rays", "shadowrays"})
                for (const json& tile : event["tiles"][ray])
                    for (const json& bin : tile["bins"]) {
                        const std::set<uint32_t> ids = bin["ids"].get<std::set<uint32_t>>();
                        EXPECT_EQ(
                            ids, lists.at({tile["view"], tile["column"], tile["row"], bin["bin"]}));
                        EXPECT_EQ(ids.size(), bin["ids"].size());
                        entries += ids.size();
                        seen.insert(ids.begin(), ids.end());
                    }
            const uint32_t hit = event["hits"]["primitive"];
            EXPECT_TRUE(hit == 4294967295u || seen.contains(hit)) << hit;
        }
        EXPECT_EQ(found["radiance"], found["events"].back()["image"]);
    }
    EXPECT_GT(events, 8u);
    EXPECT_GT(shadows, 4u);
    EXPECT_TRUE(!hasGrid || entries > 50u) << entries;
}

INSTANTIATE_TEST_SUITE_P(Backends, DumpedPixel, testing::Values("cpu", "gl", "embree"),
                         [](const auto& info) { return std::string(info.param); });

class DumpedPixelOfCpu : public DumpedPixel {};

TEST_P(DumpedPixelOfCpu, MayBeRasterizedOrOneEvent) {
    const json raster = pixel(20, 14);
    EXPECT_EQ(raster["events"][0]["rasterized"], true);
    EXPECT_TRUE(raster["events"][0]["hits"].is_null());
    EXPECT_FALSE(raster["events"][1]["hits"].is_null());
    const json one = pixel(20, 14, {"--event", "1"});
    ASSERT_EQ(one["events"].size(), 1u);
    EXPECT_EQ(one["events"][0], raster["events"][1]);
    const Outcome run = dump({"--pixel", "20,14", "-o", folder_ / "pixel.json", "--json"});
    EXPECT_EQ(run.out, readFile(folder_ / "pixel.json"));
}

TEST_P(DumpedPixelOfCpu, EndsInOneLine) {
    const auto refuses = [&](const std::vector<std::string>& options, const char* says) {
        const Outcome run = dump(options);
        EXPECT_EQ(run.status, 2);
        EXPECT_NE(run.err.find(says), std::string::npos) << run.err;
        EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    };
    const std::string to = folder_ / "a.json";
    refuses({"--pixel", "40,3", "-o", to}, "--pixel 40,3: the image has 40x28 pixels");
    refuses({"--pixel", "4", "-o", to}, "--pixel");
    refuses({"--pixel", "4,4", "-o", folder_ / "a"}, "with --pixel its name has to end in .json");
    refuses({"--pixel", "4,4", "--buffers", "ids", "-o", to},
            "--buffers: has no effect with --pixel");
    refuses({"--pixel", "4,4", "--event", "3", "-o", to}, "--event 3");
    EXPECT_FALSE(std::filesystem::exists(to));
    EXPECT_FALSE(std::filesystem::exists(folder_ / "a"));
}

INSTANTIATE_TEST_SUITE_P(Backends, DumpedPixelOfCpu, testing::Values("cpu"));

} // namespace
} // namespace dirt::test
