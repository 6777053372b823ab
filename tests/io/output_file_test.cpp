#include "core/base/error.h"
#include "core/io/find_file.h"
#include "core/io/input_files.h"
#include "core/io/output_file.h"
#include "core/io/text_file.h"
#include "tests/support/temporary_folder.h"

#include <csignal>
#include <set>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace dirt {
namespace {

class Output : public testing::Test {
protected:
    void write(OutputFile& file, const std::string& text) {
        file.write(std::as_bytes(std::span(text)));
    }
    test::TemporaryFolder folder_;
    const std::string path_ = folder_.write("a.txt", "old");
};

/// Both ways to write: without a name, and where the file system knows no such files.
constexpr OutputFile::Temporary kWays[] = {OutputFile::Temporary::unnamed,
                                           OutputFile::Temporary::named};

TEST_F(Output, TakesItsPlaceWhenItIsWhole) {
    for (const auto way : kWays)
        for (const bool there : {true, false}) {
            const std::string path = there ? folder_.write("a.txt", "old") : folder_ / "b.txt";
            OutputFile file(path, way);
            write(file, "new ");
            write(file, "text");
            EXPECT_EQ(test::readFile(path), there ? "old" : "");
            file.takePlace();
            EXPECT_EQ(test::readFile(path), "new text");
            EXPECT_EQ(folder_.names().contains("b.txt"), !there);
            std::filesystem::remove(folder_ / "b.txt");
            EXPECT_EQ(folder_.names(), std::set<std::string>{"a.txt"});
        }
}

TEST_F(Output, LeavesNothingWhereItIsGivenUp) {
    for (const auto way : kWays) {
        {
            OutputFile file(path_, way);
            write(file, "new");
            EXPECT_EQ(folder_.names().size(), way == OutputFile::Temporary::named ? 2u : 1u);
        }
        EXPECT_EQ(test::readFile(path_), "old");
        EXPECT_EQ(folder_.names(), std::set<std::string>{"a.txt"});
    }
}

/// A process that is killed while it writes.
TEST_F(Output, LeavesNothingForLongWhereItIsKilled) {
    for (const auto way : kWays) {
        const pid_t child = fork();
        if (child == 0) {
            OutputFile file(path_, way);
            write(file, "new");
            kill(getpid(), SIGKILL);
        }
        waitpid(child, nullptr, 0);
        EXPECT_EQ(test::readFile(path_), "old");
        EXPECT_EQ(folder_.names().size(), way == OutputFile::Temporary::named ? 2u : 1u);
        writeFile(folder_ / "other.txt", "other"); // takes nothing away that is not its own
        EXPECT_EQ(folder_.names().size(), way == OutputFile::Temporary::named ? 3u : 2u);
        OutputFile(path_, way).takePlace();
        EXPECT_EQ(folder_.names(), (std::set<std::string>{"a.txt", "other.txt"}));
        folder_.write("a.txt", "old");
        std::filesystem::remove(folder_ / "other.txt");
    }
}

/// What is between the name that a link gets and its renaming.
TEST_F(Output, ReplacesALinkThatWasLeftBehind) {
    writeFile(path_, "new");
    std::string hidden;
    {
        OutputFile file(path_, OutputFile::Temporary::named);
        for (const std::string& name : folder_.names())
            if (name != "a.txt") hidden = name;
    }
    ASSERT_NE(hidden, "");
    folder_.write(hidden, "left");
    writeFile(path_, "newer");
    EXPECT_EQ(test::readFile(path_), "newer");
    EXPECT_EQ(folder_.names(), std::set<std::string>{"a.txt"});
}

TEST_F(Output, OfManyAtOnceLeavesOneWhole) {
    for (const auto way : kWays) {
        std::vector<std::thread> writers;
        for (int i = 0; i < 8; ++i)
            writers.emplace_back([&, i] {
                for (int k = 0; k < 20; ++k) {
                    OutputFile file(path_, way);
                    write(file, std::string(1000, (char) ('a' + i)));
                    file.takePlace();
                }
            });
        for (std::thread& writer : writers) writer.join();
        const std::string text = test::readFile(path_);
        EXPECT_EQ(text, std::string(1000, text[0]));
        EXPECT_EQ(folder_.names(), std::set<std::string>{"a.txt"});
    }
}

TEST_F(Output, KeepsTheModeOfWhatItReplaces) {
    using std::filesystem::perms;
    for (const auto way : kWays)
        for (const perms mode : {perms(0600), perms(0664), perms(0755)}) {
            std::filesystem::permissions(path_, mode);
            OutputFile(path_, way).takePlace();
            EXPECT_EQ(std::filesystem::status(path_).permissions(), mode);
        }
    const mode_t mask = umask(027);
    writeFile(folder_ / "b.txt", "new");
    umask(mask);
    EXPECT_EQ(std::filesystem::status(folder_ / "b.txt").permissions(), perms(0640));
}

TEST_F(Output, WritesWhereLinksLead) {
    namespace fs = std::filesystem;
    for (const auto way : kWays) {
        folder_.write("to/b.txt", "old");
        fs::remove(folder_ / "link");
        fs::remove(folder_ / "link2");
        fs::create_symlink("to/b.txt", folder_ / "link");
        fs::create_symlink(folder_ / "link", folder_ / "link2");
        OutputFile(folder_ / "link2", way).takePlace();
        EXPECT_TRUE(fs::is_symlink(folder_ / "link") && fs::is_symlink(folder_ / "link2"));
        EXPECT_EQ(test::readFile(folder_ / "to/b.txt"), "");
        fs::remove(folder_ / "to/b.txt"); // a link to what is not there yet
        OutputFile(folder_ / "link2", way).takePlace();
        EXPECT_TRUE(fs::exists(folder_ / "to/b.txt") && fs::is_symlink(folder_ / "link"));
        fs::remove(folder_ / "link");
        fs::create_symlink("link2", folder_ / "link"); // a ring
        EXPECT_THROW(OutputFile(folder_ / "link", way), InputError);
    }
}

TEST_F(Output, DoesNotReplaceWhatIsWriteProtected) {
    std::filesystem::permissions(path_, std::filesystem::perms(0444));
    if (access(path_.c_str(), W_OK) == 0) GTEST_SKIP() << "this user may write everywhere";
    EXPECT_THROW(writeFile(path_, "new"), InputError);
    EXPECT_EQ(test::readFile(path_), "old");
}

/// What refuses to write there, or "".
std::string refusal(const std::string& path) {
    try {
        checkWritable(path);
        return "";
    } catch (const InputError& error) {
        return error.what();
    }
}

TEST_F(Output, SparesInputs) {
    namespace fs = std::filesystem;
    fs::create_hard_link(path_, folder_ / "hard");
    fs::create_symlink("a.txt", folder_ / "soft");
    fs::create_directory_symlink(".", folder_ / "here");
    fs::create_symlink("b.TXT", folder_ / "dangling");
    readBytes(path_); // counts for nothing: there is no InputFiles
    EXPECT_EQ(refusal(path_), "");
    {
        const InputFiles outer;
        {
            const InputFiles inputs;
            readBytes(path_);
            for (const char* name : {"a.txt", "hard", "soft", "here/a.txt", "here/hard"})
                EXPECT_EQ(refusal(folder_ / name),
                          folder_ / name + ": cannot write: the input is read from this file");
            // On a file system where case matters these are no files of the input.
            EXPECT_EQ(refusal(folder_ / "A.txt"), "");
            EXPECT_EQ(findFile(folder_.path(), "B.txt"), std::nullopt);
            for (const char* name : {"b.txt", "B.TXT", "here/b.Txt", "dangling"})
                EXPECT_NE(refusal(folder_ / name).find("the input names this file"),
                          std::string::npos)
                    << name;
            EXPECT_EQ(refusal(folder_ / "c.txt"), "");
        }
        EXPECT_EQ(refusal(path_), "");
    }
}

/// An input that is read after the file was opened.
TEST_F(Output, SparesInputsToTheEnd) {
    const InputFiles inputs;
    OutputFile file(path_);
    write(file, "new");
    readBytes(path_);
    EXPECT_THROW(file.takePlace(), InputError);
    EXPECT_EQ(test::readFile(path_), "old");
}

TEST_F(Output, IsTheSamePlaceThroughLinks) {
    std::filesystem::create_symlink("a.txt", folder_ / "soft");
    std::filesystem::create_directory_symlink(".", folder_ / "here");
    EXPECT_TRUE(isSamePlace(path_, folder_ / "soft"));
    EXPECT_TRUE(isSamePlace(folder_ / "none", folder_ / "here/none"));
    EXPECT_FALSE(isSamePlace(folder_ / "none", folder_ / "none2"));
    EXPECT_FALSE(isSamePlace(path_, folder_ / "none"));
}

using OutputDeathTest = Output;

TEST_F(OutputDeathTest, AnExitIsImmediateWhereNothingIsWritten) {
    EXPECT_EXIT(
        {
            exitBetweenFiles(7);
            _exit(1);
        },
        testing::ExitedWithCode(7), "");
}

TEST_F(OutputDeathTest, AnExitWaitsForTheFile) {
    const auto writeAndExit = [&] {
        OutputFile file(path_);
        write(file, "new");
        exitBetweenFiles(7);
        write(file, " text");
        file.takePlace();
    };
    EXPECT_EXIT(
        {
            writeAndExit();
            _exit(1);
        },
        testing::ExitedWithCode(7), "");
    EXPECT_EQ(test::readFile(path_), "new text");
    EXPECT_EQ(folder_.names(), std::set<std::string>{"a.txt"});
}

TEST_F(OutputDeathTest, AnExitWaitsForTheFilesRemoval) {
    const auto failAndExit = [&] {
        OutputFile file(path_, OutputFile::Temporary::named);
        write(file, "new");
        exitBetweenFiles(7);
        throw InputError("given up");
    };
    EXPECT_EXIT(
        {
            try {
                failAndExit();
            } catch (const InputError&) {
            }
            _exit(1);
        },
        testing::ExitedWithCode(7), "");
    EXPECT_EQ(test::readFile(path_), "old");
    EXPECT_EQ(folder_.names(), std::set<std::string>{"a.txt"});
}

} // namespace
} // namespace dirt
