// `dirt preview` as its users run it.

#include "core/io/image.h"
#include "tests/cli/program.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace dirt::test {
namespace {

class Preview : public testing::Test {
protected:
    Outcome preview(std::vector<std::string> options) {
        options.insert(options.begin(), {"preview", scene_, "--size", "32x16", "-o", picture_});
        return dirt(options);
    }
    std::string error(const std::vector<std::string>& options) {
        const Outcome run = preview(options);
        EXPECT_EQ(run.status, 2);
        EXPECT_FALSE(std::filesystem::exists(picture_));
        return run.err;
    }

    TemporaryFolder folder_;
    std::string scene_ = litTriangle(folder_), picture_ = folder_ / "picture.png";
};

TEST_F(Preview, WritesAPictureThatSaysWhatItIs) {
    const Outcome run = preview({"--show", "entries", "--tile", "8", "--bins", "4"});
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_NE(run.err.find("picture.png: entries, 0 to "), std::string::npos) << run.err;
    const Image image = readImage(picture_);
    EXPECT_EQ(image.width, 6); // three views of 16 pixels
    EXPECT_EQ(image.height, 4);
    const ImageMetadata metadata = readMetadata(picture_);
    const auto has = [&](const std::string& key, const std::string& value) {
        return std::find(metadata.begin(), metadata.end(), std::pair(key, value)) != metadata.end();
    };
    EXPECT_TRUE(has("dirt:show", "entries"));
    EXPECT_TRUE(has("dirt:backend", "cpu"));
}

TEST_F(Preview, ListsWhatThereIs) {
    const Outcome run = dirt({"preview", "--list"});
    EXPECT_EQ(run.status, 0) << run.err;
    for (const char* name : {"image ", "entries ", "normal ", "shadowmap "})
        EXPECT_NE(run.out.find(name), std::string::npos) << name;
}

TEST_F(Preview, RefusesWhatItCannotShow) {
    EXPECT_EQ(error({"--show", "pixels"}),
              "dirt: --show 'pixels': dirt preview --list names what there is\n");
    EXPECT_EQ(error({"--show", "near", "--bin", "0"}),
              "dirt: --bin: has no effect with --show near\n");
    EXPECT_EQ(error({"--show", "hits", "--level", "1"}),
              "dirt: --level: has no effect with --show hits\n");
    EXPECT_EQ(error({"--show", "near", "--event", "1"}),
              "dirt: --event: has no effect with --show near\n");
    EXPECT_EQ(error({"--show", "hits", "--spp", "2"}),
              "dirt: --spp: has no effect with --show hits\n");
    EXPECT_NE(error({"--show", "shadowmap"}).find("this frame has none"), std::string::npos);
    for (const auto& [file, said] :
         {std::pair(folder_ / "a.exr", std::string("a preview is a PNG")),
          std::pair(folder_ / "none/a.png", std::string("none"))}) {
        const Outcome run = dirt({"preview", scene_, "-o", file});
        EXPECT_EQ(run.status, 2);
        EXPECT_NE(run.err.find(said), std::string::npos) << run.err;
    }
}

} // namespace
} // namespace dirt::test
