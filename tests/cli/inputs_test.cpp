// No command writes over a file that it reads, or would read if it were there: one line, status 2,
// and all files are as before. With a scene whose parts lie beside it, as users have them.

#include "core/io/image.h"
#include "tests/cli/program.h"
#include "tests/support/random.h"

#include <algorithm>
#include <map>
#include <thread>

#include <gtest/gtest.h>
#include <sys/stat.h>

namespace dirt::test {
namespace {

namespace fs = std::filesystem;

/// A folder with scenes, made the current one for as long as it lives: where -o is not given, the
/// program writes there.
class Inputs : public testing::Test {
protected:
    Inputs() {
        fs::current_path(folder_.path());
        const std::vector<uint8_t> rgb(2 * 2 * 3, 128);
        for (const char* name :
             {"crate.png", "other.PNG", "unused.png", "skin.png", "extra.png", "model.png"})
            writePng(name, 2, 2, rgb, {});
        folder_.write("crate.obj", std::string("mtllib crate.mtl\nusemtl a\n") + kTriangleObj);
        folder_.write("crate.mtl", "newmtl a\nmap_Kd crate.png\nmap_Ks Other.png\nnewmtl b\n"
                                   "map_Kd -s 1 1 1 unused.png\nmap_Kd gone.png\n");
        folder_.write("a.scene", "<world><object file=\"crate.obj\"/></world>");
        folder_.write("lack.obj", std::string("mtllib lack.mtl\nusemtl a\n") + kTriangleObj);
        folder_.write("lack.mtl", "newmtl a\nmap_Kd Lack.PNG\n");
        folder_.write("model.gltf", gltf("model.bin"));
        std::string floats;
        for (const float value : {-1.f, -1.f, -2.f, 1.f, -1.f, -2.f, 0.f, 1.f, -2.f})
            floats.append((const char*) &value, sizeof value);
        folder_.write("model.bin", floats);
        fs::create_symlink("crate.png", "soft.png");
        fs::create_hard_link("crate.png", "hard.png");
        fs::create_directory_symlink(".", "here");
    }
    ~Inputs() override { fs::current_path(before_); }

    static std::string gltf(const std::string& buffer) {
        return "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"uri\":\"" + buffer +
               "\",\"byteLength\":36}],\"bufferViews\":[{\"buffer\":0,\"byteLength\":36}],"
               "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":"
               "\"VEC3\"}],\"images\":[{\"uri\":\"skin.png\"},{\"uri\":\"extra.png\"}],"
               "\"textures\":[{\"source\":0}],\"materials\":[{\"pbrMetallicRoughness\":"
               "{\"baseColorTexture\":{\"index\":0}}}],\"meshes\":[{\"primitives\":[{"
               "\"attributes\":"
               "{\"POSITION\":0},\"material\":0}]}],\"nodes\":[{\"mesh\":0}]}";
    }

    /// All files with a number for what they hold.
    std::map<std::string, size_t> contents() const {
        std::map<std::string, size_t> files;
        for (const auto& entry : fs::recursive_directory_iterator(folder_.path()))
            files[entry.path().string()] = std::hash<std::string>()(
                entry.is_regular_file() ? readFile(entry.path()) : std::string("a folder"));
        return files;
    }

    /// Whether the command ends in one line that names \p victim, and touches nothing.
    void expectRefusal(const std::vector<std::string>& arguments, const std::string& victim,
                       const std::string& says = ": cannot write: ") {
        std::string command;
        for (const std::string& argument : arguments) command += argument + " ";
        SCOPED_TRACE(command);
        const auto before = contents();
        const Outcome run = dirt(arguments);
        EXPECT_EQ(run.status, 2);
        EXPECT_EQ(run.out, "");
        EXPECT_EQ(run.err.rfind("dirt: " + victim + says, 0), 0u) << run.err;
        EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
        EXPECT_EQ(contents(), before);
    }

    static std::vector<std::string> render(const std::string& scene,
                                           std::vector<std::string> more = {}) {
        // Of this many samples none is taken.
        std::vector<std::string> all{"render",  scene,   "--quiet", "--size",
                                     "512x512", "--spp", "1000000"};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }

    TemporaryFolder folder_;
    const fs::path before_ = fs::current_path();
};

TEST_F(Inputs, TheDefaultNameSparesATexture) {
    expectRefusal(render("crate.obj"), "crate.png",
                  ": cannot write: crate.obj uses a file of this name; give the picture another, "
                  "as in -o crate-render.png");
    folder_.write("crate-render.png", "mine");
    expectRefusal(render("crate.obj"), "crate.png",
                  ": cannot write: crate.obj uses a file of this name; give the picture another, "
                  "as in -o crate-render-2.png");
    // One that is not there would become the texture.
    expectRefusal(render("lack.obj"), "lack.png",
                  ": cannot write: lack.obj uses a file of this name; give the picture another, "
                  "as in -o lack-render.png");
    // With frames the names are others.
    folder_.write("crate.mtl", "newmtl a\nmap_Kd crate.0001.png\n");
    expectRefusal(render("crate.obj", {"--frames", "0:2"}), "crate.0001.png");
}

TEST_F(Inputs, RenderSparesWhatTheSceneIsMadeOf) {
    for (const char* victim : {"crate.png", "soft.png", "hard.png", "here/crate.png", "other.PNG",
                               "Other.png", "unused.png", "gone.png", "GONE.png"})
        for (const char* scene : {"crate.obj", "a.scene"})
            expectRefusal(render(scene, {"-o", victim}), victim);
    for (const char* victim :
         {"crate.png", "a.scene", "crate.obj", "crate.mtl", "here/crate.mtl", "hard.png"})
        expectRefusal(render("a.scene", {"-o", "x.png", "--stats", victim}), victim);
    for (const char* victim : {"skin.png", "extra.png"})
        expectRefusal(render("model.gltf", {"-o", victim}), victim);
    for (const char* victim : {"model.gltf", "model.bin"})
        expectRefusal(render("model.gltf", {"-o", "x.png", "--stats", victim}), victim);
    // Nor is one output written over the other.
    expectRefusal(render("crate.obj", {"-o", "x.png", "--stats", "x.png"}), "--stats x.png",
                  ": the picture");
    fs::create_symlink("x.png", "y.png");
    expectRefusal(render("crate.obj", {"-o", "x.png", "--stats", "y.png"}), "--stats y.png",
                  ": the picture");
}

TEST_F(Inputs, WhatIsNoPartOfTheSceneIsReplaced) {
    folder_.write("x.png", "old");
    for (const char* output : {"x.png", "model.png", "Crate.png"})
        EXPECT_EQ(
            dirt({"render", "crate.obj", "--quiet", "--size", "8x8", "--spp", "1", "-o", output})
                .status,
            0)
            << output;
    EXPECT_NE(readFile("x.png"), "old");
    EXPECT_EQ(dirt({"render", "model.gltf", "--quiet", "--size", "8x8", "--spp", "1"}).status, 0);
}

TEST_F(Inputs, CachesAreSparedAndSpare) {
    std::string big = "mtllib crate.mtl\nusemtl a\n" + std::string(kTriangleObj);
    while (big.size() < (1 << 16)) big += "# so that it is worth a cache\n";
    folder_.write("big.obj", big);
    const std::vector<std::string> info{"info", "big.obj"};
    folder_.write("big.obj.sbin", "another program's");
    setenv("XDG_CACHE_HOME", (folder_ / "user").c_str(), 1);
    ASSERT_EQ(dirt(info).status, 0);
    EXPECT_EQ(readFile("big.obj.sbin"), "another program's");
    EXPECT_TRUE(fs::exists("user/dirt"));
    fs::remove("big.obj.sbin");
    fs::remove_all("user");
    ASSERT_EQ(dirt(info).status, 0);
    expectRefusal(render("big.obj", {"-o", "x.png", "--stats", "crate.mtl"}), "crate.mtl");
    ASSERT_TRUE(fs::exists("big.obj.sbin"));
    expectRefusal(render("big.obj", {"-o", "x.png", "--stats", "big.obj.sbin"}), "big.obj.sbin");
}

TEST_F(Inputs, CompareSparesBothImages) {
    for (const char* victim : {"crate.png", "skin.png", "soft.png", "here/skin.png"})
        expectRefusal({"compare", "crate.png", "skin.png", "--diff", victim}, victim);
    EXPECT_EQ(dirt({"compare", "crate.png", "skin.png", "--diff", "x.png"}).status, 0);
}

TEST_F(Inputs, DumpSparesAScenesFolder) {
    // A scene beside files that have a dump's names.
    fs::create_directory("in");
    fs::create_directory("out");
    writeExr("in/hits.1.exr", Image{1, 1, {glm::vec3(1.0f)}}, {});
    folder_.write("in/b.mtl", "newmtl a\nmap_Kd hits.1.exr\n");
    folder_.write("in/b.obj", std::string("mtllib b.mtl\nusemtl a\n") + kTriangleObj);
    expectRefusal({"dump", "in/b.obj", "--size", "8x8", "-o", "in"}, "in/hits.1.exr");
    fs::create_symlink("../in/hits.1.exr", "out/depth.exr");
    expectRefusal({"dump", "in/b.obj", "--size", "8x8", "-o", "out"}, "out/depth.exr");
    EXPECT_EQ(TemporaryFolder::namesIn("out"), (std::set<std::string>{"depth.exr"}));
    EXPECT_EQ(dirt({"dump", "in/b.obj", "--size", "8x8", "--buffers", "ids", "-o", "in"}).status,
              0);
}

#ifdef DIRT_HAVE_EMBREE
TEST_F(Inputs, BenchesSpareThem) {
    folder_.write("known.json", "{}");
    fs::create_directory("tables");
    expectRefusal({"bench", "tradeoff", "crate.obj", "--size", "8x8", "--quiet", "-o", "tables",
                   "--errors", "known.json"},
                  "known.json", ": is not the JSON");
    fs::create_hard_link("known.json", "tables/crate-tradeoff.json");
    expectRefusal({"bench", "tradeoff", "crate.obj", "--size", "8x8", "--quiet", "-o", "tables",
                   "--errors", "known.json"},
                  "tables/crate-tradeoff.json");
    fs::create_hard_link("crate.png", "tables/crate-memory.svg");
    fs::remove("tables/crate-tradeoff.json");
    expectRefusal({"bench", "tradeoff", "crate.obj", "--size", "8x8", "--quiet", "-o", "tables"},
                  "tables/crate-memory.svg");
    if (!fullTests()) return; // its largest image takes long
    // What it makes only to time it goes to a folder of its own.
    folder_.write("tables/scenes/mine.scene", "mine");
    EXPECT_EQ(dirt({"bench", "scaling", "--size", "8x8", "--rounds", "1", "--most", "10000", "-o",
                    "tables"})
                  .status,
              0);
    EXPECT_EQ(readFile("tables/scenes/mine.scene"), "mine");
}
#endif

} // namespace
} // namespace dirt::test
