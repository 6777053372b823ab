#include "core/io/texture_file.h"

#include "shaders/shared/radiance.h"
#include "tests/io/input_error.h"
#include "tests/support/captured_stream.h"
#include "tests/support/random.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/write_image.h"

#include <gtest/gtest.h>

#include <cfloat>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

namespace dirt {
namespace {

using test::TexelType;

/// Writes an image of one row from float values, converted to the given type.
std::filesystem::path writeTexels(const std::filesystem::path& file, int channels, TexelType type,
                                  const std::vector<float>& values) {
    return test::writeImage(file, (int) values.size() / channels, 1, channels, type, values);
}

constexpr auto kByte = TexelType::uint8;

TEST(TextureFile, ReadsColour) {
    const test::TemporaryFolder folder;
    const Texture t = readTexture(DecodedImage(
        writeTexels(folder.path() / "a.png", 3, kByte, {1.0f, 0.0f, 0.0f, 0.0f, 1.0f, 1.0f})));
    EXPECT_EQ(t.width(), 2);
    EXPECT_EQ(t.height(), 1);
    EXPECT_EQ(t.bytes(), 6u);
    EXPECT_EQ(t.sample({0.25f, 0.5f}), glm::vec3(1, 0, 0));
    EXPECT_EQ(t.sample({0.75f, 0.5f}), glm::vec3(0, 1, 1));
    EXPECT_EQ(t.file(), (folder.path() / "a.png").string());
}

TEST(TextureFile, MakesGreyOfOneChannel) {
    const test::TemporaryFolder folder;
    const Texture t =
        readTexture(DecodedImage(writeTexels(folder.path() / "a.png", 1, kByte, {1.0f})));
    EXPECT_EQ(t.sample({0, 0}), glm::vec3(1));
    const Texture alpha =
        readTexture(DecodedImage(writeTexels(folder.path() / "b.png", 2, kByte, {1.0f, 0.0f})));
    EXPECT_EQ(alpha.sample({0, 0}), glm::vec3(1));
}

/// Colour, alpha and data of one decoded image are those of images decoded for each.
TEST(TextureFile, ReadsSeveralThingsOfOneImage) {
    const test::TemporaryFolder folder;
    for (const auto type : {TexelType::uint8, TexelType::uint16, TexelType::float32})
        for (const int channels : {2, 4}) {
            std::vector<float> values;
            for (int i = 0; i < 6 * channels; ++i) values.push_back((float) (i % 7) / 6.0f);
            const char* name = type == TexelType::float32 ? "a.tif" : "a.png";
            const auto file = writeTexels(folder.path() / name, channels, type, values);
            const DecodedImage image{file};
            const auto alpha = readAlpha(image);
            const Texture colour = readTexture(image);
            const ScalarTexture data = readScalarTexture(image);
            const auto alone = readAlpha(DecodedImage(file));
            ASSERT_TRUE(alpha && alone);
            const Texture same = readTexture(DecodedImage(file));
            for (int x = 0; x < 6; ++x) {
                const size_t at = (size_t) (x * channels);
                EXPECT_EQ(alpha->texel(x, 0), alone->texel(x, 0));
                EXPECT_NEAR(alpha->texel(x, 0), values[at + (size_t) channels - 1], 1.0f / 255.0f);
                EXPECT_NEAR(data.texel(x, 0), values[at], 1.0f / 255.0f);
                const glm::vec2 middle{((float) x + 0.5f) / 6.0f, 0.5f};
                EXPECT_EQ(colour.sample(middle), same.sample(middle));
            }
        }
}

TEST(TextureFile, DoesNotMultiplyByAlpha) {
    const test::TemporaryFolder folder;
    const Texture t = readTexture(
        DecodedImage(writeTexels(folder.path() / "a.png", 4, kByte, {1.0f, 1.0f, 0.0f, 0.0f})));
    EXPECT_EQ(t.sample({0, 0}), glm::vec3(1, 1, 0));
}

/// Sixteen bits of an sRGB colour are sixteen bits still, of which eight would leave nothing of a
/// dark one.
TEST(TextureFile, ReadsDeepIntegersAsSrgbToo) {
    const test::TemporaryFolder folder;
    for (const char* name : {"a.png", "a.tif"}) {
        const Texture t = readTexture(DecodedImage(
            writeTexels(folder.path() / name, 3, TexelType::uint16, {0.001f, 0.5f, 1.0f})));
        const glm::vec3 colour = t.sample({0, 0});
        EXPECT_NEAR(colour.x, 66.0 / 65535.0 / 12.92, 1e-11); // 7.79e-5; 0.001 is between two steps
        EXPECT_NEAR(colour.y, 0.21404, 2e-5);
        EXPECT_EQ(colour.z, 1.0f);
    }
}

TEST(TextureFile, ReadsFloatsAsTheyAre) {
    const test::TemporaryFolder folder;
    const Texture t = readTexture(DecodedImage(
        writeTexels(folder.path() / "a.exr", 3, TexelType::half, {0.5f, 0.25f, 100.0f})));
    EXPECT_EQ(t.bytes(), 12u);
    EXPECT_EQ(t.sample({0, 0}), glm::vec3(0.5f, 0.25f, 100.0f));
}

TEST(TextureFile, TakesFloatsThatAreNoColourForOthers) {
    const test::TemporaryFolder folder;
    const float inf = std::numeric_limits<float>::infinity();
    const DecodedImage image(writeTexels(folder.path() / "a.exr", 3, TexelType::float32,
                                         {-1.0f, std::nanf(""), inf, 1e30f, 5.0f, -inf}));
    const Texture colour = readTexture(image);
    EXPECT_EQ(image.takeFault(),
              "5 numbers are not from 0 to 7.92282e+28: the nearest is taken, for a NaN 0");
    EXPECT_EQ(colour.sample({0.25f, 0.5f}), glm::vec3(0, 0, kMostRadiance));
    EXPECT_EQ(colour.sample({0.75f, 0.5f}), glm::vec3(kMostRadiance, 5, 0));
    EXPECT_EQ(colour.range().largest, kMostRadiance);

    const Texture data = readDataTexture(image);
    EXPECT_EQ(image.takeFault(),
              "3 numbers are not finite: a NaN is taken for 0, an infinity for 3.40282e+38");
    EXPECT_EQ(data.sample({0.25f, 0.5f}), glm::vec3(-1, 0, FLT_MAX));
    EXPECT_EQ(data.range().least, -FLT_MAX);

    EXPECT_EQ(readScalarTexture(image, ImageChannel::red).range().least, -1.0f);
    EXPECT_EQ(image.takeFault(), "") << "this channel has none";
    EXPECT_EQ(readScalarTexture(image, ImageChannel::green).texel(0, 0), 0.0f);
    EXPECT_EQ(image.takeFault(),
              "1 numbers are not finite: a NaN is taken for 0, an infinity for 3.40282e+38");
}

TEST(TextureFile, RefusesWhatIsNoImage) {
    const test::TemporaryFolder folder;
    for (const std::string& file :
         {folder.write("text.png", "this is no image\n"), folder.write("empty.jpg", ""),
          folder / "none.png", folder.write("unknown.xyz", "?"), folder.path().string()}) {
        const std::string what = inputError([&] { readTexture(DecodedImage(file)); });
        EXPECT_EQ(what.rfind(file + ": ", 0), 0u) << what;
        EXPECT_EQ(what.find('\n'), std::string::npos) << what;
    }
}

TEST(TextureFile, TakesPngsUnderAnyName) {
    const test::TemporaryFolder folder;
    const auto png = writeTexels(folder.path() / "a.png", 3, kByte, {1.0f, 0.0f, 1.0f});
    EXPECT_EQ(readTexture(DecodedImage(folder.write("b.jpg", test::readFile(png)))).sample({0, 0}),
              glm::vec3(1, 0, 1));
}

TEST(TextureFile, NamesWhatIsWrongWithAPng) {
    const test::TemporaryFolder folder;
    const std::string bytes = test::readFile(
        writeTexels(folder.path() / "a.png", 3, kByte, std::vector<float>(300, 0.5f)));
    const auto errorOf = [&](const std::string& content) {
        const std::string file = folder.write("b.png", content);
        const std::string what = inputError([&] { readTexture(DecodedImage(file)); });
        return what.empty() ? what : what.substr(file.size());
    };
    EXPECT_EQ(errorOf(bytes), "");
    for (const size_t length : {(size_t) 8, (size_t) 20, bytes.size() / 2, bytes.size() - 1})
        EXPECT_EQ(errorOf(bytes.substr(0, length)), ": damaged image: the file ends early");
    std::string flipped = bytes;
    flipped[18] ^= 1; // the width
    EXPECT_EQ(errorOf(flipped), ": damaged image: IHDR: CRC error");
    std::string text = bytes;
    text.erase(4, 1); // the carriage return
    EXPECT_EQ(errorOf(text), ": damaged image: PNG file corrupted by ASCII conversion");
    std::string endless = bytes;
    endless[8] = '\xff'; // the first chunk's length
    EXPECT_EQ(errorOf(endless), ": damaged image: PNG unsigned integer out of range");
}

/// Texels that a PNG's sound chunks do not hold are missed by libpng, which prints nothing.
TEST(TextureFile, SaysNothingBesidesItsError) {
    const test::TemporaryFolder folder;
    const auto file = writeTexels(folder.path() / "a.png", 3, kByte, std::vector<float>(30, 0.5f));
    std::string bytes = test::readFile(file);
    const size_t data = bytes.find("IDAT"), end = bytes.find("IEND") - 4;
    bytes.erase(data - 4, end - (data - 4)); // no texels at all
    test::CapturedStream err(stderr);
    const std::string name = folder.write("b.png", bytes);
    const std::string what = inputError([&] { readTexture(DecodedImage(name)); });
    EXPECT_EQ(err.text(), "");
    EXPECT_EQ(what.rfind(name + ": damaged image: ", 0), 0u) << what;
}

/// Formats that OpenImageIO would take, but that are not looked into: its reader of Maya's IFF
/// writes beyond its memory.
TEST(TextureFile, ReadsTheListedFormatsAlone) {
    const test::TemporaryFolder folder;
    const std::string iff("FOR4\0\0\0\x20"
                          "CIMGTBHD\0\0\0\x18",
                          20);
    const std::string gif("GIF89a\1\0\1\0\x80\0\0", 13);
    for (const std::string& bytes : {iff, gif, std::string("8BPS\0\1", 6)}) {
        const std::string file = folder.write("a.png", bytes);
        EXPECT_EQ(inputError([&] { readTexture(DecodedImage(file)); }),
                  file + ": is none of the images that are read: PNG, JPEG, OpenEXR, Radiance HDR, "
                         "TIFF, BMP, TGA, WebP, DDS, PNM and PFM");
    }
}

/// A few bytes that claim a large image are refused before memory is taken for it.
TEST(TextureFile, RefusesClaimsThatTheBytesCannotHold) {
    const test::TemporaryFolder folder;
    const std::string hdr = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 16384 +X 16384\n";
    const std::string pfm = "PF\n16384 16384\n-1.0\n", ppm = "P6\n16384 16384\n255\n";
    std::string tga(18, '\0');
    tga[2] = 2;
    tga[13] = tga[15] = 0x40;
    tga[16] = 24;
    for (const std::string& bytes : {hdr, pfm, ppm, tga}) {
        const std::string file = folder.write("a.xyz", bytes);
        EXPECT_EQ(inputError([&] { readTexture(DecodedImage(file)); }),
                  file + ": damaged image: " + std::to_string(bytes.size()) +
                      " bytes cannot hold the 16384x16384 texels of its header");
    }
}

class DamagedTexture : public testing::TestWithParam<const char*> {};

/// Cut off or with a few bytes changed, a file is read or refused in one line, and no library
/// prints a line of its own.
TEST_P(DamagedTexture, EndsInOneLine) {
    const test::TemporaryFolder folder;
    const std::string extension = GetParam();
    std::vector<float> noise(3 * 4096);
    for (size_t i = 0; i < noise.size(); ++i) noise[i] = (float) (i * 7919 % 256) / 255.0f;
    const std::string bytes =
        test::readFile(writeTexels(folder.path() / ("whole." + extension), 3, kByte, noise));
    test::Random random(1);
    int refused = 0;
    for (int i = 0; i < test::cases(60, 2000); ++i) {
        std::string damaged = bytes;
        if (i % 2 == 0)
            damaged.resize((size_t) random.below((int) bytes.size()));
        else
            for (int k = random.range(1, 3); k > 0; --k)
                damaged[(size_t) random.below((int) bytes.size())] = (char) random.below(256);
        const std::string file = folder.write("damaged." + extension, damaged);
        test::CapturedStream err(stderr);
        const std::string what = inputError([&] { readTexture(DecodedImage(file)); });
        EXPECT_EQ(err.text(), "") << i;
        EXPECT_TRUE(what.empty() || what.rfind(file + ": ", 0) == 0) << what;
        EXPECT_EQ(what.find('\n'), std::string::npos) << what;
        refused += !what.empty();
    }
    EXPECT_GT(refused, 0);
}

INSTANTIATE_TEST_SUITE_P(Formats, DamagedTexture,
                         testing::Values("png", "jpg", "tga", "tif", "bmp", "exr", "hdr", "webp",
                                         "ppm"),
                         [](const auto& info) { return std::string(info.param); });

TEST(TextureFile, TellsNormalsFromHeights) {
    const test::TemporaryFolder folder;
    const auto isNormals = [&](int channels, TexelType type, const std::vector<float>& values) {
        const char* name = type == kByte ? "a.png" : "a.exr";
        return isNormalMap(DecodedImage(writeTexels(folder.path() / name, channels, type, values)));
    };
    const std::vector<float> flat{0.5f, 0.5f, 1.0f};
    const std::vector<float> tilted{0.5f, 0.5f, 1.0f, 0.85f, 0.5f, 0.857f, 0.3f, 0.2f, 0.845f};
    const std::vector<float> wood{0.6f, 0.45f, 0.3f, 0.5f, 0.35f, 0.2f};
    const std::vector<float> heights{0.0f, 0.0f, 0.0f, 0.4f, 0.4f, 0.4f, 1.0f, 1.0f, 1.0f};
    const std::vector<float> inwards{0.5f, 0.5f, 0.0f};
    for (const auto type : {kByte, TexelType::float32}) {
        EXPECT_TRUE(isNormals(3, type, flat));
        EXPECT_TRUE(isNormals(3, type, tilted));
        EXPECT_FALSE(isNormals(3, type, wood));
        EXPECT_FALSE(isNormals(3, type, heights));
        EXPECT_FALSE(isNormals(3, type, inwards));
        EXPECT_FALSE(isNormals(1, type, {0.5f}));
    }
    EXPECT_TRUE(isNormals(4, kByte, {0.5f, 0.5f, 1.0f, 1.0f}));
}

/// A grey image needs no floats for its luminance.
TEST(TextureFile, KeepsTheLuminanceOfGreyInBytes) {
    const test::TemporaryFolder folder;
    const auto luminance = [&](const std::vector<float>& values) {
        return readScalarTexture(
            DecodedImage(writeTexels(folder.path() / "a.png", 3, kByte, values)),
            ImageChannel::luminance);
    };
    const ScalarTexture grey = luminance({0.2f, 0.2f, 0.2f, 0.6f, 0.6f, 0.6f});
    EXPECT_EQ(grey.bytes(), 2u);
    EXPECT_EQ(grey.sample({0.25f, 0.5f}), 0.2f);
    EXPECT_EQ(luminance({0.2f, 0.2f, 0.2f, 0.6f, 0.6f, 0.2f}).bytes(), 8u);
}

/// Their colours are divided by an alpha that may be zero, which ends the process in OpenImageIO.
TEST(TextureFile, DdsWithPremultipliedAlphaIsNotRead) {
    for (const char* kind : {"DXT2", "DXT4"}) {
        std::string bytes(144, '\0'); // 4x4 texels: a header and a block, all zero but what is said
        const auto put = [&](size_t at, const std::string& value) {
            bytes.replace(at, value.size(), value);
        };
        put(0, "DDS \x7c");
        put(8, {7, 16, 8});
        put(12, {4});
        put(16, {4});
        put(76, {32});
        put(80, {4});
        put(84, kind);
        put(109, {16});
        const test::TemporaryFolder folder;
        const std::string file = folder.write("a.dds", bytes);
        EXPECT_NE(inputError([&] { readTexture(DecodedImage(file)); }).find("DDS"),
                  std::string::npos)
            << kind;
    }
}

} // namespace
} // namespace dirt
