// What all text readers share: lines, numbers, UTF-8, printable messages.

#include "core/io/load_report.h"
#include "core/io/number.h"
#include "core/io/text_file.h"
#include "core/io/utf8.h"
#include "tests/io/input_error.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace dirt {
namespace {

using Lines = std::vector<std::pair<size_t, std::string>>;

Lines linesOf(std::string_view text,
              LineReader::Continuation continuation = LineReader::Continuation::backslash) {
    Lines lines;
    for (LineReader reader(text, continuation); reader.next();)
        lines.emplace_back(reader.number(), reader.line());
    return lines;
}

TEST(LineReader, EndsLinesAtAnyLineEndingAndAtTheEnd) {
    EXPECT_EQ(linesOf("a\nb\r\nc\rd"), (Lines{{1, "a"}, {2, "b"}, {3, "c"}, {4, "d"}}));
    EXPECT_EQ(linesOf("a\n\n\nb\n"), (Lines{{1, "a"}, {2, ""}, {3, ""}, {4, "b"}}));
    EXPECT_EQ(linesOf(""), Lines());
}

TEST(LineReader, JoinsLinesThatEndInABackslash) {
    EXPECT_EQ(linesOf("f 1 2\\\n3 \\\r\n4\nv"), (Lines{{1, "f 1 2 3  4"}, {4, "v"}}));
    EXPECT_EQ(linesOf("f 1\\"), (Lines{{1, "f 1 "}}));
    EXPECT_EQ(linesOf("a\\\nb", LineReader::Continuation::none), (Lines{{1, "a\\"}, {2, "b"}}));
}

TEST(LineReader, DoesNotContinueComments) {
    EXPECT_EQ(linesOf(" # C:\\\nv 1"), (Lines{{1, " # C:\\"}, {2, "v 1"}}));
}

TEST(TextFile, SkipsAByteOrderMark) {
    const test::TemporaryFolder folder;
    EXPECT_EQ(readTextFile(folder.write("a.obj", "\xef\xbb\xbfv")), "v");
}

TEST(TextFile, RefusesWhatIsNoText) {
    const test::TemporaryFolder folder;
    const auto errorOf = [](const std::filesystem::path& file) {
        return inputError([&] { readTextFile(file); });
    };
    const std::string utf16 = folder.write("utf16.obj", std::string("\xfe\xff\0v", 4));
    const std::string nul = folder.write("nul.obj", std::string("v 1\nv \0", 7));
    EXPECT_EQ(errorOf(utf16), utf16 + ":1: is UTF-16; only ASCII and UTF-8 text can be read");
    EXPECT_EQ(errorOf(nul), nul + ":2: holds a NUL byte: not a text file");
    EXPECT_EQ(errorOf(folder.path()), folder.path().string() + ": is a folder, not a file");
    EXPECT_EQ(errorOf(folder.path() / "none"),
              (folder.path() / "none").string() + ": no such file");
    EXPECT_EQ(errorOf("/dev/zero"), "/dev/zero: is a device, not a file");
}

TEST(Number, ReadsEveryCommonForm) {
    EXPECT_EQ(parseNumber("1"), 1.0);
    EXPECT_EQ(parseNumber("+2."), 2.0);
    EXPECT_EQ(parseNumber("-.5"), -0.5);
    EXPECT_EQ(parseNumber("3.25E+2"), 325.0);
    EXPECT_EQ(parseNumber("1e-400"), 0.0);
    EXPECT_TRUE(std::signbit(*parseNumber("-0")));
    EXPECT_EQ(parseNumber("0.1"), 0.1); // the compiler rounds correctly too
    EXPECT_EQ(parseNumber("123456789012345678901234567890"), 123456789012345678901234567890.0);
}

TEST(Number, KeepsWhatIsNotFiniteApart) {
    for (const char* text : {"nan", "NaN", "-nan", "inf", "-Infinity", "1e999", "-1e999",
                             "-nan(ind)", "1.#QNAN", "-1.#IND00", "+1.#INF", "1.#R"}) {
        ASSERT_TRUE(parseNumber(text)) << text;
        EXPECT_FALSE(fitsFloat(*parseNumber(text))) << text;
    }
    EXPECT_FALSE(fitsFloat(*parseNumber("3.5e38")));
    EXPECT_TRUE(fitsFloat(*parseNumber("3.4e38")));
}

TEST(Number, RefusesEverythingElse) {
    for (const char* text : {"", "+", "-", ".", "e5", "1e", "1,5", "1.2.3", "0x10", "++1", "+-1",
                             "1f", "1 ", "3.1+e2", "1.#", "2.#INF", "1.#INF.", "11.#QNAN"})
        EXPECT_FALSE(parseNumber(text)) << text;
    EXPECT_EQ(parseInteger("+12"), 12);
    for (const char* text : {"", "1.5", "99999999999", "1e3", "0x1"})
        EXPECT_FALSE(parseInteger(text)) << text;
}

TEST(Utf8, KnowsSequencesAndTheirLimits) {
    EXPECT_EQ(utf8Length("a"), 1u);
    EXPECT_EQ(utf8Length("\xc3\xa9"), 2u);
    EXPECT_EQ(utf8Length("\xe2\x82\xac"), 3u);
    EXPECT_EQ(utf8Length("\xf0\x9f\x98\x80"), 4u);
    for (const char* bad :
         {"", "\x80", "\xc0\x80", "\xc1\xbf", "\xe0\x80\x80", "\xed\xa0\x80", "\xf0\x80\x80\x80",
          "\xf4\x90\x80\x80", "\xf5\x80\x80\x80", "\xe2\x82", "\xc3z"})
        EXPECT_EQ(utf8Length(bad), 0u) << testing::PrintToString(bad);
}

TEST(Printable, IsOneLineOfValidUtf8) {
    EXPECT_EQ(printable("a\nb\tc\x7f"), "a?b?c?");
    EXPECT_EQ(printable("d\xfcster \xc3\xa9"), "d?ster \xc3\xa9");
    EXPECT_EQ(printable(std::string(1000, 'x')), std::string(200, 'x') + "...");
}

TEST(LoadReport, KeepsEachWarningAndNameOnce) {
    LoadReport report;
    for (int i = 0; i < 2; ++i) {
        report.warn(WarningKind::undefinedMaterial, "a.obj", 3, "is missing");
        report.ignore("b");
        report.ignore("a");
    }
    ASSERT_EQ(report.warnings().size(), 1u);
    EXPECT_EQ(report.warnings()[0].text, "a.obj:3: is missing");
    EXPECT_EQ(report.ignored(), (std::vector<std::string>{"b", "a"}));
}

TEST(FaultCounter, TellsTheFirstOfAKindAndCountsTheOthers) {
    FaultCounter counter;
    for (size_t line = 5; line < 9; ++line)
        counter.add(WarningKind::unusableAttribute, "normal", line,
                    [&] { return "bad normal " + std::to_string(line); });
    counter.add(WarningKind::skippedGeometry, "face", 6, [] { return "no face"; });
    LoadReport report;
    report.warn("a.obj", counter.faults());
    ASSERT_EQ(report.warnings().size(), 2u);
    EXPECT_EQ(report.warnings()[0].text, "a.obj:5: bad normal 5 (4 times)");
    EXPECT_EQ(report.warnings()[0].kind, WarningKind::unusableAttribute);
    EXPECT_EQ(report.warnings()[1].text, "a.obj:6: no face");
    LoadReport strict(true);
    EXPECT_EQ(inputError([&] { strict.warn("a.obj", counter.faults()); }),
              "a.obj:5: bad normal 5 (4 times)");
}

} // namespace
} // namespace dirt
