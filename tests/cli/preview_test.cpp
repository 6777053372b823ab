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
    EXPECT_EQ(image.width, 768);       // three views of two tiles, enlarged
    EXPECT_EQ(image.height, 512 + 42); // with the scale below
    const ImageMetadata metadata = readMetadata(picture_);
    const auto has = [&](const std::string& key, const std::string& value) {
        return std::find(metadata.begin(), metadata.end(), std::pair(key, value)) != metadata.end();
    };
    EXPECT_TRUE(has("dirt:show", "entries"));
    EXPECT_TRUE(has("dirt:backend", "cpu"));
}

TEST_F(Preview, MarksPathsAndShowsTheViewsAround) {
    for (const std::vector<std::string>& options :
         {std::vector<std::string>{"--show", "entries", "--path", "16,8", "--event", "0"},
          {"--show", "normal", "--path", "16,8", "--point", "current", "--event", "1"},
          {"--show", "overview", "--path", "16,8", "--sample", "1"},
          {"--show", "overview", "--buffer", "near", "--tile", "4", "--level", "1"},
          {"--path", "16,8"}}) {
        const Outcome run = preview(options);
        EXPECT_EQ(run.status, 0) << run.err;
        EXPECT_GE(readImage(picture_).width, 768);
        std::filesystem::remove(picture_);
    }
}

TEST_F(Preview, ListsWhatThereIs) {
    const Outcome run = dirt({"preview", "--list"});
    EXPECT_EQ(run.status, 0) << run.err;
    for (const char* name : {"image ", "overview ", "entries ", "time ", "normal ", "shadowmap "})
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
    EXPECT_EQ(error({"--show", "entries", "--event", "0"}),
              "dirt: --event: has no effect with --show entries\n");
    EXPECT_EQ(error({"--show", "hits", "--point", "next"}),
              "dirt: --point: has no effect with --show hits\n");
    EXPECT_EQ(error({"--show", "hits", "--buffer", "near"}),
              "dirt: --buffer: has no effect with --show hits\n");
    EXPECT_EQ(error({"--show", "overview", "--buffer", "hits"}),
              "dirt: --buffer 'hits': one of near, far, entries, first\n");
    EXPECT_EQ(error({"--show", "overview", "--level", "1"}),
              "dirt: --level: has no effect with --show overview --buffer entries\n");
    EXPECT_EQ(error({"--show", "shadowmap", "--path", "0,0"}),
              "dirt: --path: has no effect with --show shadowmap\n");
    EXPECT_EQ(error({"--path", "32,0"}), "dirt: --path 32,0: the image has 32x16 pixels\n");
    EXPECT_EQ(error({"--show", "near", "--path", "0,0", "--event", "3"}),
              "dirt: --event 3: the path events of 3 bounces are 0 to 2\n");
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
