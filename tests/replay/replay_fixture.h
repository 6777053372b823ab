#pragma once

#include "tests/cli/program.h"

#include <filesystem>
#include <functional>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace dirt::test {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// Dumps that an independent script wrote by rational arithmetic: tests/replay/write_dump.py.
class Replay : public testing::Test {
protected:
    static void SetUpTestSuite() {
        folder_ = new TemporaryFolder;
        const Outcome run =
            start("/usr/bin/python3", {std::string(DIRT_SOURCE_DIR) + "/tests/replay/write_dump.py",
                                       *folder_ / "dumps"});
        written_ = run.status == 0;
        EXPECT_TRUE(written_ || run.status == 127) << run.err;
    }
    static void TearDownTestSuite() { delete folder_; }
    void SetUp() override {
        if (!written_) GTEST_SKIP() << "there is no /usr/bin/python3";
    }

    static std::string dump(const std::string& name) { return *folder_ / ("dumps/" + name); }

    /// A copy of the right dump with one file edited.
    static std::string edited(const std::string& file,
                              const std::function<void(std::string&)>& edit) {
        const std::string copy = *folder_ / "edited";
        fs::remove_all(copy);
        fs::copy(dump("right"), copy);
        std::string text = readFile(copy + "/" + file);
        edit(text);
        folder_->write("edited/" + file, text);
        return copy;
    }

    static Json replay(const std::string& folder, int status) {
        const Outcome run = dirt({"replay", folder, "--json", "--quiet"});
        EXPECT_EQ(run.status, status) << run.err;
        EXPECT_EQ(run.err, "");
        return Json::parse(run.out);
    }

    static inline TemporaryFolder* folder_ = nullptr;
    static inline bool written_ = false;
};

inline std::string nameOf(const Json& pass) {
    return pass["pass"].get<std::string>() +
           (pass["event"].is_null() ? "" : " " + pass["event"].dump());
}

inline void replaceOnce(std::string& text, const std::string& what, const std::string& by) {
    const size_t at = text.find(what);
    ASSERT_NE(at, std::string::npos) << what;
    text.replace(at, what.size(), by);
}

/// Line \p number of \p text, counted from 1, becomes \p line.
inline void setLine(std::string& text, size_t number, const std::string& line) {
    size_t begin = 0;
    for (size_t i = 1; i < number; ++i) begin = text.find('\n', begin) + 1;
    text.replace(begin, text.find('\n', begin) - begin, line);
}

} // namespace dirt::test
