// --memory, and what is refused within it before it is allocated.

#include "tests/cli/program.h"

#include <algorithm>

#include <gtest/gtest.h>

#include <sys/resource.h>

namespace dirt::test {
namespace {

/// One line with all of \p parts, status 2.
void expectLine(const Outcome& run, const std::vector<std::string>& parts) {
    EXPECT_EQ(run.status, 2) << run.err;
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    for (const std::string& part : parts)
        EXPECT_NE(run.err.find(part), std::string::npos) << part << " is not in " << run.err;
}

TEST(Memory, IsASize) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("a.obj", kTriangleObj);
    for (const char* size : {"2G", "2GB", "2g", "2.5G", "2000M", "2000000000", "1T", "3000000K"})
        EXPECT_EQ(dirt({"info", scene, "--size", "16x16", "--memory", size}).status, 0) << size;
    for (const char* size : {"", "G", "-1G", "1", "2X", "nan", "infG", "0.5M", "2GG", "1e30G"})
        expectLine(dirt({"info", scene, "--memory", size}),
                   {"--memory:", std::string("'") + size + "'"});
}

TEST(Memory, IsThatOfAFrameToo) {
    const TemporaryFolder folder;
    const std::string scene = litTriangle(folder);
    // 400 million tiles for one triangle.
    for (const char* backend : {"cpu", "gl"})
        expectLine(dirt({"render", scene, "--view-size", "8192", "--tile", "1", "--bins", "4",
                         "--memory", "8G", "--backend", backend, "-o", folder / "x.png"}),
                   {"--tile 1 --bins 4", "GB", "8.0 GB", "would fit"});
    expectLine(
        dirt({"render", scene, "--size", "4000x2000", "--memory", "400M", "-o", folder / "x.png"}),
        {"a frame needs about ", "MB", "400 MB are left"});
    expectLine(
        dirt({"dump", scene, "--size", "2000x1000", "--memory", "1200M", "-o", folder / "dump"}),
        {"a dump of 2000x1000 pixels needs ", "(--memory)"});
    for (const std::vector<std::string>& command :
         {std::vector<std::string>{"verify"}, {"check"}, {"bench", "frame"}}) {
        std::vector<std::string> arguments = command;
        arguments.insert(arguments.end(), {scene, "--memory", "1M"});
        const Outcome run = dirt(arguments);
        if (run.status == 3) continue; // without Embree, or OpenGL
        expectLine(run, {"memory", "1 MB"});
    }
    EXPECT_FALSE(std::filesystem::exists(folder / "x.png"));
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

/// The most that a process of ours that has ended had in memory.
int64_t mostResident() {
    rusage usage{};
    getrusage(RUSAGE_CHILDREN, &usage);
    return usage.ru_maxrss * 1024;
}

TEST(Memory, SmallFilesDoNotCostMuch) {
    const TemporaryFolder folder;
    constexpr const char* kZeros = "{\"asset\":{\"version\":\"2.0\"},\"accessors\":[{"
                                   "\"componentType\":5126,\"count\":262143,\"type\":\"VEC3\"}],"
                                   "\"meshes\":[{\"primitives\":[";
    const auto repeated = [](const std::string& text, int times) {
        std::string all = text;
        for (int i = 1; i < times; ++i) all += "," + text;
        return all;
    };
    const std::string primitive = "{\"attributes\":{\"POSITION\":0}}";
    folder.write("nodes.gltf",
                 kZeros + primitive + "]}],\"nodes\":[" + repeated("{\"mesh\":0}", 300) + "]}");
    folder.write("primitives.gltf",
                 kZeros + repeated(primitive, 2000) + "]}],\"nodes\":[{\"mesh\":0}]}");
    const auto prepare = [] { alarm(60); };
    for (const char* name : {"nodes.gltf", "primitives.gltf"})
        expectLine(startDirt({"info", folder / name}, prepare), {"accessors[0] has no data"});

    std::string obj = "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\n", mtl;
    for (int i = 0; i < 8; ++i) {
        const std::string number = std::to_string(i);
        folder.write(
            number + ".hdr",
            std::string("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 16384 +X 16384\n\0", 54));
        mtl += "newmtl m" + number + "\nmap_Kd " + number + ".hdr\n";
        obj += "usemtl m" + number + "\nf 1/1 2/1 3/1\n";
    }
    folder.write("a.obj", obj);
    folder.write("a.mtl", mtl);
    const Outcome run = startDirt({"info", folder / "a.obj", "--size", "64x32"}, prepare);
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_NE(run.out.find("0 of 8 that are named"), std::string::npos) << run.out;
    EXPECT_EQ(run.err, "");
    EXPECT_LT(mostResident(), 300'000'000);
}

#endif

} // namespace
} // namespace dirt::test
