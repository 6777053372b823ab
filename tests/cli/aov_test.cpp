// `dirt render --aov`: layers in one EXR file, on every backend, that leave the image as it is; and
// what cannot be done ends in one line.

#include "tests/cli/program.h"

#include <algorithm>
#include <bit>
#include <map>

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

namespace dirt::test {
namespace {

const std::string kScene = DIRT_SOURCE_DIR "/scenes/cornell.scene";
constexpr const char* kAll =
    "albedo,emission,normal,geometricNormal,roughness,depth,position,id,variance";

using Channels = std::map<std::string, std::vector<uint32_t>>;

Channels channelsOf(const std::string& file) {
    Channels channels;
    const auto input = OIIO::ImageInput::open(file);
    EXPECT_TRUE(input) << file;
    for (int c = 0; input && c < input->spec().nchannels; ++c) {
        const OIIO::ImageSpec& spec = input->spec();
        const OIIO::TypeDesc type = spec.channelformat(c);
        EXPECT_EQ(type,
                  spec.channelnames[c] == "id.X" ? OIIO::TypeDesc::UINT : OIIO::TypeDesc::FLOAT)
            << spec.channelnames[c];
        auto& values = channels[spec.channelnames[c]];
        values.resize((size_t) spec.width * (size_t) spec.height);
        EXPECT_TRUE(input->read_image(0, 0, c, c + 1, type, values.data()));
    }
    EXPECT_FALSE(input && input->seek_subimage(1, 0)) << "has several parts";
    return channels;
}

class RenderedAovs : public testing::Test {
protected:
    TemporaryFolder folder_;

    Outcome render(const std::vector<std::string>& options) const {
        std::vector<std::string> arguments = {"render", kScene, "--quiet", "--size", "48x36"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        return dirt(arguments);
    }
};

TEST_F(RenderedAovs, StandBesideTheSameImage) {
    ASSERT_EQ(render({"--spp", "3", "-o", folder_ / "plain.exr"}).status, 0);
    const Outcome run = render({"--spp", "3", "--aov", kAll, "-o", folder_ / "layers.exr"});
    ASSERT_EQ(run.status, 0) << run.err;
    const Channels plain = channelsOf(folder_ / "plain.exr");
    const Channels layers = channelsOf(folder_ / "layers.exr");
    EXPECT_EQ(plain.size(), 3u);
    EXPECT_EQ(layers.size(), 3u + 6u * 3u + 3u);
    for (const char* name : {"R", "G", "B"}) EXPECT_EQ(layers.at(name), plain.at(name));
    for (const char* name : {"albedo.R", "emission.B", "normal.Y", "geometricNormal.Z",
                             "roughness.X", "depth.Z", "position.X", "id.X", "variance.G"})
        EXPECT_TRUE(layers.contains(name)) << name;
    const Outcome compared = dirt({"compare", folder_ / "plain.exr", folder_ / "layers.exr"});
    EXPECT_EQ(compared.status, 0) << compared.err;
    // And the metadata.
    const auto a = OIIO::ImageInput::open(folder_ / "plain.exr");
    const auto b = OIIO::ImageInput::open(folder_ / "layers.exr");
    for (const char* key : {"dirt:scene", "dirt:samples", "dirt:camera", "DateTime", "Software"})
        EXPECT_EQ(a->spec().get_string_attribute(key), b->spec().get_string_attribute(key)) << key;
    EXPECT_EQ(b->spec().get_string_attribute("dirt:samples"), "3");
}

TEST_F(RenderedAovs, OfOneSampleAreThoseOfItsDump) {
    ASSERT_EQ(render({"--spp", "1", "--aov", "albedo,emission,normal,geometricNormal,roughness,id",
                      "-o", folder_ / "layers.exr"})
                  .status,
              0);
    ASSERT_EQ(dirt({"dump", kScene, "--quiet", "--size", "48x36", "--buffers", "direct", "-o",
                    folder_ / "dump"})
                  .status,
              0);
    const Channels layers = channelsOf(folder_ / "layers.exr");
    Channels direct;
    const auto input = OIIO::ImageInput::open(folder_ / "dump/direct.exr");
    ASSERT_TRUE(input);
    for (int c = 0; c < input->spec().nchannels; ++c) {
        auto& values = direct[input->spec().channelnames[c]];
        values.resize(48 * 36);
        ASSERT_TRUE(
            input->read_image(0, 0, c, c + 1, input->spec().channelformat(c), values.data()));
    }
    const std::pair<const char*, const char*> same[] = {
        {"albedo.R", "diffuse.R"},       {"albedo.B", "diffuse.B"},
        {"emission.G", "emission.G"},    {"normal.X", "shadingNormal.X"},
        {"normal.Z", "shadingNormal.Z"}, {"geometricNormal.Y", "geometricNormal.Y"},
        {"roughness.X", "roughness.X"},  {"id.X", "primitive.X"}};
    for (const auto& [layer, channel] : same) {
        const auto &a = layers.at(layer), &b = direct.at(channel);
        for (size_t i = 0; i < a.size(); ++i)
            if (std::string(layer) == "id.X")
                EXPECT_EQ(a[i], b[i]) << layer;
            else // -0 is 0
                EXPECT_EQ(std::bit_cast<float>(a[i]), std::bit_cast<float>(b[i])) << layer;
    }
    const auto& ids = layers.at("id.X");
    EXPECT_GT(std::count_if(ids.begin(), ids.end(), [](uint32_t id) { return id < 36; }), 1000);
}

TEST_F(RenderedAovs, AreTheSameOnEveryBackend) {
    std::map<std::string, Channels> found;
    for (const char* backend : {"cpu", "gl", "embree"}) {
        const Outcome run =
            render({"--backend", backend, "--primary", "traced", "--spp", "2", "--bounces", "2",
                    "--aov", kAll, "-o", folder_ / backend + ".exr"});
        if (run.status == 3) continue; // there is none
        ASSERT_EQ(run.status, 0) << run.err;
        found[backend] = channelsOf(folder_ / backend + ".exr");
    }
    for (const auto& [backend, channels] : found)
        for (const auto& [name, values] : channels)
            EXPECT_EQ(values, found["cpu"].at(name)) << backend << " " << name;
}

TEST_F(RenderedAovs, EndInOneLineWhereTheyCannotBe) {
    const auto refuses = [&](const std::vector<std::string>& options, const std::string& says) {
        const Outcome run = render(options);
        EXPECT_EQ(run.status, 2);
        EXPECT_NE(run.err.find(says), std::string::npos) << run.err;
        EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    };
    const std::string to = folder_ / "a.exr";
    refuses({"--aov", "albedo,colour", "-o", to},
            "--aov colour: there are albedo,emission,normal,geometricNormal,roughness,depth,"
            "position,id,variance");
    refuses({"--aov", "id,id", "-o", to}, "--aov: id is there twice");
    refuses({"--aov", "id", "-o", folder_ / "a.png"}, "a.png: a PNG has no layers");
    refuses({"--aov", "id"}, "cornell.png: a PNG has no layers; name an EXR, as in -o cornell.exr");
    refuses({"--aov", "id,variance", "--spp", "1", "-o", to}, "--aov variance: one sample");
    refuses({"--aov", kAll, "--size", "2048x2048", "--spp", "2", "--bounces", "1", "--memory",
             "1500M", "-o", to},
            "--aov: these layers need ");
    EXPECT_FALSE(std::filesystem::exists(to));
    EXPECT_FALSE(std::filesystem::exists(folder_ / "a.png"));
}

} // namespace
} // namespace dirt::test
