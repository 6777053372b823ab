#include "core/io/texture_file.h"
#include "tests/io/input_error.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include <OpenImageIO/imageio.h>

#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/lsan_interface.h>
#endif

namespace dirt {
namespace {

/// OpenImageIO leaks a string where libpng jumps out of a damaged file.
struct LeaksAllowed {
#ifdef __SANITIZE_ADDRESS__
    __lsan::ScopedDisabler disabler;
#endif
};

/// Writes an image of one row from float values, converted to the given format.
std::filesystem::path writeImage(const std::filesystem::path& file, int channels,
                                 OIIO::TypeDesc format, const std::vector<float>& values) {
    OIIO::ImageSpec spec((int) values.size() / channels, 1, channels, format);
    spec.attribute("oiio:UnassociatedAlpha", 1);
    const auto output = OIIO::ImageOutput::create(file.string());
    EXPECT_TRUE(output && output->open(file.string(), spec) &&
                output->write_image(OIIO::TypeDesc::FLOAT, values.data()) && output->close())
        << OIIO::geterror();
    return file;
}

constexpr auto kByte = OIIO::TypeDesc::UINT8;

TEST(TextureFile, ReadsColour) {
    const test::TemporaryFolder folder;
    const Texture t = readTexture(
        writeImage(folder.path() / "a.png", 3, kByte, {1.0f, 0.0f, 0.0f, 0.0f, 1.0f, 1.0f}));
    EXPECT_EQ(t.width(), 2);
    EXPECT_EQ(t.height(), 1);
    EXPECT_EQ(t.bytes(), 6u);
    EXPECT_EQ(t.sample({0.25f, 0.5f}), glm::vec3(1, 0, 0));
    EXPECT_EQ(t.sample({0.75f, 0.5f}), glm::vec3(0, 1, 1));
    EXPECT_EQ(t.file(), (folder.path() / "a.png").string());
}

TEST(TextureFile, MakesGreyOfOneChannel) {
    const test::TemporaryFolder folder;
    const Texture t = readTexture(writeImage(folder.path() / "a.png", 1, kByte, {1.0f}));
    EXPECT_EQ(t.sample({0, 0}), glm::vec3(1));
    const Texture alpha = readTexture(writeImage(folder.path() / "b.png", 2, kByte, {1.0f, 0.0f}));
    EXPECT_EQ(alpha.sample({0, 0}), glm::vec3(1));
}

TEST(TextureFile, DoesNotMultiplyByAlpha) {
    const test::TemporaryFolder folder;
    const Texture t =
        readTexture(writeImage(folder.path() / "a.png", 4, kByte, {1.0f, 1.0f, 0.0f, 0.0f}));
    EXPECT_EQ(t.sample({0, 0}), glm::vec3(1, 1, 0));
}

TEST(TextureFile, ReadsDeepIntegersAsSrgbToo) {
    const test::TemporaryFolder folder;
    const Texture t = readTexture(
        writeImage(folder.path() / "a.png", 3, OIIO::TypeDesc::UINT16, {1.0f, 0.0f, 1.0f}));
    EXPECT_EQ(t.bytes(), 3u);
    EXPECT_EQ(t.sample({0, 0}), glm::vec3(1, 0, 1));
}

TEST(TextureFile, ReadsFloatsAsTheyAre) {
    const test::TemporaryFolder folder;
    const Texture t = readTexture(
        writeImage(folder.path() / "a.exr", 3, OIIO::TypeDesc::HALF, {0.5f, 0.25f, 100.0f}));
    EXPECT_EQ(t.bytes(), 12u);
    EXPECT_EQ(t.sample({0, 0}), glm::vec3(0.5f, 0.25f, 100.0f));
}

TEST(TextureFile, RefusesFloatsThatAreNoColour) {
    const test::TemporaryFolder folder;
    for (const float bad : {-1.0f, std::nanf(""), std::numeric_limits<float>::infinity()}) {
        const auto file =
            writeImage(folder.path() / "a.exr", 3, OIIO::TypeDesc::FLOAT, {bad, 0.0f, 0.0f});
        EXPECT_EQ(inputError([&] { readTexture(file); }),
                  file.string() + ": damaged image: a texel is negative or not finite");
    }
}

TEST(TextureFile, RefusesDamagedFilesInOneLine) {
    const test::TemporaryFolder folder;
    std::vector<float> noise(3 * 4096);
    for (size_t i = 0; i < noise.size(); ++i) noise[i] = (float) (i * 7919 % 256) / 255.0f;
    const auto whole = writeImage(folder.path() / "whole.png", 3, kByte, noise);
    std::ifstream stream(whole, std::ios::binary);
    const std::string bytes((std::istreambuf_iterator<char>(stream)), {});
    const std::filesystem::path damaged[] = {
        folder.write("text.png", "this is no image\n"), folder.write("empty.jpg", ""),
        folder.write("cut.png", bytes.substr(0, bytes.size() / 2)), folder.path() / "none.png",
        folder.write("unknown.xyz", "?")};
    for (const auto& file : damaged) {
        [[maybe_unused]] const LeaksAllowed allowed;
        const std::string what = inputError([&] { readTexture(file); });
        EXPECT_EQ(what.rfind(file.string() + ": ", 0), 0u) << what;
        EXPECT_EQ(what.find('\n'), std::string::npos) << what;
    }
}

} // namespace
} // namespace dirt
