// The file of --log: no other file is lost for it, and where it cannot be, nothing is done.

#include "core/io/image.h"
#include "tests/cli/log_fixture.h"

#include <utility>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

namespace dirt::test {
namespace {

namespace fs = std::filesystem;

using LogFileTest = LogTest;

TEST_F(LogFileTest, ReplacesALogAndNothingElse) {
    const Lines info{"info", folder_.write("plain.obj", kTriangleObj), "--size", "8x8"};
    folder_.write("log", "");
    EXPECT_EQ(run(info).status, 0);
    EXPECT_EQ(run({"info", folder_ / "none.obj"}).status, 2);
    ASSERT_EQ(messages().size(), 1u);
    EXPECT_EQ(run(info).status, 0);
    EXPECT_EQ(messages().size(), 0u);
    for (const char* text : {"mine", "2026-01-01T00:00:00.000Z note: dirty ",
                             "2026-01-01 00:00:00.000Z note: dirt 0.1: dirt info\n"}) {
        folder_.write("log", text);
        const Outcome ran = run(info);
        EXPECT_EQ(ran.status, 2);
        EXPECT_EQ(ran.out, "");
        EXPECT_EQ(ran.err,
                  "dirt: " + log_ + ": cannot write: it is no log of dirt, and would be lost\n");
        EXPECT_EQ(readFile(log_), text);
    }
    // Through a link.
    fs::remove(log_);
    fs::create_symlink("target", log_);
    EXPECT_EQ(run(info).status, 0);
    EXPECT_TRUE(fs::is_symlink(log_));
    EXPECT_EQ(messages(folder_ / "target").size(), 0u);
    EXPECT_EQ(run(info).status, 0);
}

TEST_F(LogFileTest, IsRefusedWhereItCannotBe) {
    mkfifo((folder_ / "fifo").c_str(), 0600);
    folder_.write("file", "");
    const auto names = folder_.names();
    const std::pair<std::string, std::string> places[] = {
        {folder_.path().string(), "is a folder"},
        {folder_ / "fifo", "not a regular file"},
        {"/dev/full", "not a regular file"},
        {folder_ / "none/log", "No such file or directory"},
        {folder_ / "file/log", "Not a directory"},
        {folder_ / "a.obj", "it is no log of dirt, and would be lost"},
        {folder_ / "a.scene", "it is no log of dirt, and would be lost"},
    };
    for (const auto& [place, says] : places) {
        // A render of this size would take minutes.
        const Lines render{"render", folder_ / "a.scene", "--spp", "1000000",
                           "-o",     folder_ / "a.png",   "--log", place};
        // Whoever opens a FIFO may wait for ever.
        const bool waits = says == "not a regular file";
        const Outcome ran = waits ? startDirt(render, [] { alarm(60); }) : dirt(render);
        EXPECT_EQ(ran.status, 2);
        EXPECT_EQ(ran.err, "dirt: " + place + ": cannot write: " + says + "\n");
        EXPECT_EQ(folder_.names(), names);
    }
    EXPECT_EQ(run({"info", folder_ / "a.obj"}, {"--log", log_}).err, "dirt: --log: given twice\n");
}

/// The names of files that are not there, and would be read: nothing is left there.
TEST_F(LogFileTest, IsNoInput) {
    folder_.write("part.scene", "<world><object file='part.obj'/></world>");
    folder_.write("skin.obj", std::string("mtllib skin.mtl\nusemtl a\n") + kTriangleObj);
    folder_.write("skin.mtl", "newmtl a\nmap_Kd Skin.png\nnewmtl b\nmap_Kd unused.png\n");
    const auto names = folder_.names();
    for (const auto& [scene, name] : {std::pair{"none.scene", "none.scene"},
                                      {"none.gltf", "none.gltf"},
                                      {"a.obj", "none.mtl"},
                                      {"a.obj", "NONE.mtl"},
                                      {"part.scene", "part.obj"},
                                      {"skin.obj", "Skin.png"},
                                      {"skin.obj", "skin.png"},
                                      {"skin.obj", "unused.png"}})
        for (const char* threads : {"1", "2"}) {
            const std::string place = folder_ / name;
            const Outcome ran =
                dirt({"info", folder_ / scene, "--quiet", "--threads", threads, "--log", place});
            EXPECT_EQ(ran.status, 2);
            EXPECT_EQ(ran.out, "");
            EXPECT_EQ(ran.err,
                      "dirt: " + place + ": cannot write: the input is read from this file\n");
            EXPECT_EQ(folder_.names(), names) << name;
        }
    const std::string image = folder_ / "none.exr";
    EXPECT_EQ(dirt({"compare", image, image, "--log", image}).err,
              "dirt: " + image + ": cannot write: the input is read from this file\n");
    EXPECT_EQ(folder_.names(), names);
}

TEST_F(LogFileTest, IsNoOtherOutput) {
    const std::string scene = folder_.write("plain.obj", kTriangleObj), place = folder_ / "a.png";
    fs::create_directory(folder_ / "dump");
    for (const Lines& command : {Lines{"render", scene, "-o", place},
                                 {"render", scene, "-o", folder_ / "b.png", "--stats", place},
                                 {"preview", scene, "-o", place},
                                 {"explain", scene, "--pixel", "0,0", "--image", place}}) {
        fs::remove(place);
        Lines all = command;
        all.insert(all.end(), {"--size", "8x8", "--log", place});
        const Outcome ran = dirt(all);
        EXPECT_EQ(ran.status, 2);
        EXPECT_EQ(ran.err, "dirt: " + place + ": cannot write: the log is written to this file\n");
        EXPECT_EQ(messages(place).size(), 1u);
    }
    const std::string manifest = folder_ / "dump/manifest.json";
    EXPECT_EQ(dirt({"dump", scene, "--size", "8x8", "-o", folder_ / "dump", "--log", manifest}).err,
              "dirt: " + manifest + ": cannot write: the log is written to this file\n");
    EXPECT_EQ(messages(manifest).size(), 1u);
}

TEST_F(LogFileTest, AFullDiskEndsItAlone) {
    std::string obj = kTriangleObj;
    for (int i = 0; i < 300; ++i) obj += "usemtl m" + std::to_string(i) + "\nf 1 2 3\n";
    const std::string picture = folder_ / "a.png";
    const auto render = [&](rlim_t bytes) {
        fs::remove(log_);
        fs::remove(picture);
        return startDirt({"render", folder_.write("many.obj", obj), "--quiet", "--size", "8x8",
                          "--spp", "1", "-o", picture, "--log", log_},
                         [bytes] {
                             const rlimit limit{bytes, bytes};
                             setrlimit(RLIMIT_FSIZE, &limit);
                         });
    };
    const Outcome ran = render(8000);
    EXPECT_EQ(ran.status, 0);
    EXPECT_EQ(ran.err, "dirt: " + log_ + ": cannot write: File too large: the log ends here\n");
    EXPECT_EQ(fs::file_size(log_), 8000u);
    EXPECT_EQ(readImage(picture).width, 8);
    // One that cannot begin is refused; the line on standard error is shorter.
    const Outcome none = render(120);
    EXPECT_EQ(none.status, 2);
    EXPECT_EQ(none.err, "dirt: " + log_ + ": cannot write: File too large\n");
    EXPECT_FALSE(fs::exists(log_));
    EXPECT_FALSE(fs::exists(picture));
}

} // namespace
} // namespace dirt::test
