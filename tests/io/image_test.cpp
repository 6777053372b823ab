#include "core/base/error.h"
#include "core/io/image.h"
#include "core/io/output_file.h"
#include "tests/support/temporary_folder.h"

#include <chrono>
#include <csignal>
#include <filesystem>
#include <thread>

#include <gtest/gtest.h>
#include <sys/resource.h>

namespace dirt {
namespace {

class ImageFile : public testing::Test {
protected:
    std::string path(const char* name) const { return folder_ / name; }
    size_t filesInFolder() const { return folder_.names().size(); }

    test::TemporaryFolder folder_;
};

Image gradient(int width, int height) {
    Image image{width, height, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            image.pixels.emplace_back((float) x * 1.25f, (float) y * 1e-5f, 1.0f / (float) (x + 1));
    return image;
}

std::vector<uint8_t> noise(size_t count) {
    std::vector<uint8_t> bytes(count);
    uint32_t state = 1;
    for (uint8_t& byte : bytes) byte = (uint8_t) ((state = state * 1664525u + 1013904223u) >> 24);
    return bytes;
}

const ImageMetadata kMetadata = {{"dirt:scene", "atrium"}, {"dirt:rays", "12345678901234"}};

/// The values in \p metadata of kMetadata's names.
void expectMetadata(const std::string& path) {
    const ImageMetadata read = readMetadata(path);
    for (const auto& entry : kMetadata)
        EXPECT_NE(std::find(read.begin(), read.end(), entry), read.end()) << entry.first;
}

TEST_F(ImageFile, ExrKeepsEveryBit) {
    const Image image = gradient(37, 11);
    writeExr(path("a.exr"), image, kMetadata);
    const Image read = readImage(path("a.exr"));
    ASSERT_EQ(read.width, 37);
    ASSERT_EQ(read.height, 11);
    EXPECT_EQ(read.pixels, image.pixels);
    expectMetadata(path("a.exr"));
    EXPECT_EQ(filesInFolder(), 1u);
}

TEST_F(ImageFile, PngKeepsEveryByte) {
    const std::vector<uint8_t> bytes = noise(3 * 23 * 19);
    writePng(path("a.png"), 23, 19, bytes, kMetadata);
    const Image read = readImage(path("a.png"));
    ASSERT_EQ(read.width, 23);
    ASSERT_EQ(read.height, 19);
    for (size_t i = 0; i < bytes.size(); ++i)
        ASSERT_EQ((int) (read.pixels[i / 3][(int) (i % 3)] * 255.0f + 0.5f), bytes[i]) << i;
    expectMetadata(path("a.png"));
    EXPECT_EQ(filesInFolder(), 1u);
}

TEST_F(ImageFile, EqualImagesAreEqualFiles) {
    const Image image = gradient(64, 64);
    const std::vector<uint8_t> bytes = noise(3 * 64 * 64);
    writeExr(path("a.exr"), image, kMetadata);
    writePng(path("a.png"), 64, 64, bytes, kMetadata);
    std::this_thread::sleep_for(std::chrono::milliseconds(1100)); // time stamps count seconds
    writeExr(path("b.exr"), image, kMetadata);
    writePng(path("b.png"), 64, 64, bytes, kMetadata);
    EXPECT_EQ(test::readFile(path("a.exr")), test::readFile(path("b.exr")));
    EXPECT_EQ(test::readFile(path("a.png")), test::readFile(path("b.png")));
}

TEST_F(ImageFile, FormatGoesByTheExtension) {
    EXPECT_EQ(imageFormat("a.PNG"), ImageFormat::png);
    EXPECT_EQ(imageFormat("b/c.d/a.exr"), ImageFormat::exr);
    EXPECT_THROW(imageFormat("a.jpg"), InputError);
    EXPECT_THROW(imageFormat("png"), InputError);
}

TEST_F(ImageFile, BadTargetsAreRefused) {
    const Image image = gradient(4, 4);
    EXPECT_THROW(writeExr(path("missing/a.exr"), image, {}), InputError);
    EXPECT_THROW(checkWritable(path("missing/a.exr")), InputError);
    std::filesystem::create_directory(path("folder.exr"));
    EXPECT_THROW(writeExr(path("folder.exr"), image, {}), InputError);
    EXPECT_THROW(writeExr("/dev/null", image, {}), InputError);
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
    EXPECT_NO_THROW(checkWritable(path("fine.exr")));
    EXPECT_EQ(filesInFolder(), 1u) << "only folder.exr";
}

/// While it lives, no file of this process grows beyond \p bytes, as on a full disk.
class FullDisk {
public:
    explicit FullDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
        getrlimit(RLIMIT_FSIZE, &saved_);
        const rlimit limit{bytes, saved_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FullDisk() {
        setrlimit(RLIMIT_FSIZE, &saved_);
        std::signal(SIGXFSZ, handler_);
    }

private:
    void (*handler_)(int);
    rlimit saved_{};
};

TEST_F(ImageFile, FullDiskLeavesWhatWasThere) {
    const std::vector<uint8_t> bytes = noise(3 * 256 * 256);
    writeFile(path("a.png"), std::string("old"));
    // From a disk without room at all to one that takes a part of the file.
    for (rlim_t limit : {0, 100, 4096}) {
        const FullDisk disk(limit);
        EXPECT_THROW(writePng(path("a.png"), 256, 256, bytes, kMetadata), InputError) << limit;
        EXPECT_THROW(writeExr(path("b.exr"), gradient(256, 256), {}), InputError) << limit;
    }
    {
        // Small enough for any library's buffer, which hides the error until the file is closed.
        const FullDisk disk(100);
        EXPECT_THROW(writePng(path("a.png"), 16, 16, std::span(bytes).first(768), {}), InputError);
    }
    EXPECT_EQ(test::readFile(path("a.png")), "old");
    EXPECT_EQ(filesInFolder(), 1u);
}

TEST_F(ImageFile, WhatIsNoImageIsRefused) {
    writeFile(path("a.exr"), std::string("no image"));
    EXPECT_THROW(readImage(path("a.exr")), InputError);
    EXPECT_THROW(readImage(path("missing.png")), InputError);
}

} // namespace
} // namespace dirt
