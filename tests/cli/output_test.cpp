// Output that cannot be written: one line, exit status 2, and what was there before stays. The
// table holds every file that the program writes.

#include "tests/cli/program.h"

#include <algorithm>
#include <functional>
#include <map>

#include <sys/resource.h>

#include <gtest/gtest.h>

namespace dirt::test {
namespace {

struct Writer {
    const char* label;
    const char* file; ///< what is written last
    /// Arguments that write the file to the path.
    std::function<std::vector<std::string>(const TemporaryFolder&, const std::string& path)> run;
};

void PrintTo(const Writer& writer, std::ostream* out) {
    *out << writer.label;
}

std::vector<std::string> render(const TemporaryFolder& folder, const char* spp,
                                std::vector<std::string> more) {
    std::vector<std::string> arguments{"render", litTriangle(folder), "--size", "128x64", "--spp",
                                       spp};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

std::string folderOf(const std::string& path) {
    return std::filesystem::path(path).parent_path().string();
}

std::vector<std::string> dump(const TemporaryFolder& folder, const std::string& path,
                              std::vector<std::string> more) {
    std::vector<std::string> arguments{"dump", litTriangle(folder), "--size", "128x64", "--quiet",
                                       "-o",   folderOf(path)};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

const Writer kWriters[] = {
    {"png", "a.png",
     [](const TemporaryFolder& folder, const std::string& path) {
         return render(folder, "2", {"-o", path});
     }},
    {"exr", "a.exr",
     [](const TemporaryFolder& folder, const std::string& path) {
         return render(folder, "2", {"-o", path});
     }},
    {"stats", "a.json",
     [](const TemporaryFolder& folder, const std::string& path) {
         return render(folder, "1",
                       {"--size", "1x1", "--quiet", "-o", folder / "b.png", "--stats", path});
     }},
    {"generate", "cornell.obj",
     [](const TemporaryFolder&, const std::string& path) {
         return std::vector<std::string>{"generate", "cornell", "-o", folderOf(path)};
     }},
    {"dump_parts", "depth.exr",
     [](const TemporaryFolder& folder, const std::string& path) {
         return dump(folder, path, {"--buffers", "depth"});
     }},
    {"dump_deep", "ids.exr",
     [](const TemporaryFolder& folder, const std::string& path) {
         return dump(folder, path, {"--buffers", "ids"});
     }},
    {"dump_manifest", "manifest.json",
     [](const TemporaryFolder& folder, const std::string& path) {
         return dump(folder, path, {"--buffers", "rays", "--bounces", "1"});
     }},
    {"diff", "a.png",
     [](const TemporaryFolder& folder, const std::string& path) {
         const std::string image = folder / "image.exr", other = folder / "other.exr";
         dirt(render(folder, "1", {"--quiet", "-o", image}));
         dirt(render(folder, "1", {"--quiet", "--seed", "1", "-o", other}));
         return std::vector<std::string>{"compare", image, other, "--diff", path};
     }},
};

/// All files below a folder with what they hold.
std::map<std::string, std::string> contents(const std::filesystem::path& folder) {
    std::map<std::string, std::string> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
        if (entry.is_regular_file()) files[entry.path().string()] = readFile(entry.path());
    return files;
}

void expectLine(const Outcome& run, const std::string& part) {
    EXPECT_EQ(run.status, 2) << run.err;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_EQ(run.err.rfind("dirt: ", 0), 0u) << run.err;
    EXPECT_NE(run.err.find(part), std::string::npos) << part << " is not in " << run.err;
}

class Output : public testing::TestWithParam<Writer> {
protected:
    std::vector<std::string> arguments(const std::string& path) {
        return GetParam().run(folder_, path);
    }
    TemporaryFolder folder_;
};

TEST_P(Output, IsWrittenWhereItCanBe) {
    const std::string path = folder_ / GetParam().file;
    const Outcome run = dirt(arguments(path));
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_GT(std::filesystem::file_size(path), 1000u) << "the limit below is half of it";
}

TEST_P(Output, NeedsAFolder) {
    folder_.write("file", "");
    const std::string name = GetParam().file;
    const auto inFile = arguments(folder_ / "file/" + name);
    const auto inNone = arguments(folder_ / "none/" + name);
    const auto before = contents(folder_.path());
    expectLine(dirt(inFile), folder_ / "file");
    // generate and dump make their folder if they can.
    const std::string label = GetParam().label;
    if (label != "generate" && label.substr(0, 4) != "dump")
        expectLine(dirt(inNone), folder_ / "none");
    EXPECT_EQ(contents(folder_.path()), before);
}

TEST_P(Output, DoesNotGoToDevices) {
    std::filesystem::create_directory(folder_ / "out");
    const std::string path = folder_ / "out/" + GetParam().file;
    std::filesystem::create_symlink("/dev/full", path);
    expectLine(dirt(arguments(path)), path + ": cannot write: not a regular file");
    EXPECT_TRUE(std::filesystem::is_symlink(path));
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
}

TEST_P(Output, StaysAsItWasWhereTheDiskIsFull) {
    std::filesystem::create_directory(folder_ / "out");
    // An earlier dump's manifest goes first of all; another file of that name would stay.
    const bool isManifest = GetParam().label == std::string("dump_manifest");
    const std::string path =
        folder_.write("out/" + std::string(GetParam().file),
                      isManifest ? "{\"backend\":\"cpu\",\"files\":[]}" : "old");
    const std::vector<std::string> all = arguments(path);
    const auto before = contents(folder_.path());
    const Outcome run = startDirt(all, [] {
        // The line on standard error is shorter.
        const rlimit limit{500, 500};
        setrlimit(RLIMIT_FSIZE, &limit);
    });
    expectLine(run, ": cannot write: File too large");
    EXPECT_EQ(readFile(path), isManifest ? "" : "old");
    for (const auto& [file, text] : contents(folder_.path()))
        EXPECT_TRUE(before.contains(file) || text.size() <= 500u)
            << file << " is no temporary file and not cut off";
    for (const std::string& name : folder_.names()) EXPECT_NE(name[0], '.') << name;
    for (const auto& entry : std::filesystem::directory_iterator(folder_ / "out"))
        EXPECT_NE(entry.path().filename().string()[0], '.') << entry.path();
}

INSTANTIATE_TEST_SUITE_P(All, Output, testing::ValuesIn(kWriters),
                         [](const auto& info) { return std::string(info.param.label); });

TEST(Render, BadOutputEndsBeforeTheRender) {
    const TemporaryFolder folder;
    for (const std::string& output :
         {folder / "missing/a.png", folder / "a.jpg", folder.path().string()}) {
        // A render of this size would take minutes.
        const Outcome run = dirt({"render", litTriangle(folder), "--spp", "1000000", "-o", output});
        EXPECT_EQ(run.status, 2);
        EXPECT_NE(run.err.find(output), std::string::npos) << run.err;
    }
    EXPECT_EQ(dirt({"render", litTriangle(folder), "--spp", "1000000", "-o", folder / "a.png",
                    "--stats", "/dev/null"})
                  .status,
              2);
    EXPECT_FALSE(std::filesystem::exists(folder / "a.png"));
}

/// Standard output that is a full disk.
TEST(StandardOutput, ThatTakesNothingIsAnError) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("a.obj", kTriangleObj);
    const auto fill = [] {
        if (!std::freopen("/dev/full", "w", stdout)) _exit(126);
    };
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{"info", scene}, {"info", scene, "--json"}, {"--help"}})
        expectLine(startDirt(arguments, fill), "standard output: cannot write: No space left");
}

} // namespace
} // namespace dirt::test
