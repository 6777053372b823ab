#include "core/io/error.h"
#include "core/io/output_file.h"
#include "tests/support/temporary_folder.h"

#include <set>
#include <span>
#include <string>

#include <gtest/gtest.h>
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

TEST_F(Output, TakesItsPlaceWhenItIsWhole) {
    {
        OutputFile file(path_);
        write(file, "new ");
        write(file, "text");
        EXPECT_EQ(test::readFile(path_), "old");
        file.takePlace();
        EXPECT_EQ(test::readFile(path_), "new text");
    }
    EXPECT_EQ(folder_.names(), std::set<std::string>{"a.txt"});
}

TEST_F(Output, LeavesNothingWhereItIsGivenUp) {
    {
        OutputFile file(path_);
        write(file, "new");
        EXPECT_EQ(folder_.names().size(), 2u);
    }
    EXPECT_EQ(test::readFile(path_), "old");
    EXPECT_EQ(folder_.names(), std::set<std::string>{"a.txt"});
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
        OutputFile file(path_);
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
