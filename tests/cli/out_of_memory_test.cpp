// Wherever memory is out, in loading, building, a frame or on the way out: one line that says so,
// no file that is half there, and a process that goes on. Or it did not matter, and the picture is
// the right one.

#include "core/io/image.h"
#include "tests/cli/program.h"
#include "tests/io/gltf_writer.h"
#include "tests/support/failing_memory.h"
#include "tests/support/random.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

namespace dirt::test {
namespace {

/// A scene of each kind of file: OBJ with MTL and textures, large enough to be cached; glTF with an
/// embedded image; cut-outs, gloss, heights, a light, a shape that moves.
class OutOfMemory : public testing::Test {
protected:
    OutOfMemory() {
        const std::vector<uint8_t> texels = {255, 0, 0, 0, 0, 255, 0, 255, 0, 0, 0, 255};
        writePng(folder_ / "colours.png", 2, 2, texels, {});
        folder_.write("a.mtl", "newmtl a\nmap_Kd colours.png\nNs 90\nKs .5 .5 .5\nmap_bump "
                               "colours.png\nmap_d -imfchan r colours.png\nNi 1.5\nnewmtl b\n"
                               "map_Kd none.png\nKd 2 1 1\n");
        folder_.write("a.obj", "mtllib a.mtl\nv -1 -1 -2\nv 1 -1 -2\nv 0 1 -2\nv 1 1 -3\nvt 0 0\n"
                               "vt 1 0\nvt 0 1\nusemtl a\nf 1/1 2/2 3/3\nusemtl b\n"
                               "f 1/1 2/2 4/2 3/3\n#" +
                                   std::string(70'000, ' '));
        GltfWriter gltf;
        const size_t image = gltf.view(readFile(folder_ / "colours.png"));
        gltf.json["images"] = Json::array({{{"bufferView", image}, {"mimeType", "image/png"}}});
        gltf.json["textures"] = Json::array({{{"source", 0}}});
        gltf.json["materials"] =
            Json::array({{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}},
                          {"emissiveFactor", {0.5, 0.25, 0}}}});
        const size_t positions = gltf.vec3({-3, -2, -4, 3, -2, -4, 0, 3, -5}),
                     texcoords = gltf.vec2({0, 0, 1, 0, 0, 1});
        const size_t mesh =
            gltf.mesh({{"attributes", {{"POSITION", positions}, {"TEXCOORD_0", texcoords}}},
                       {"material", 0}});
        gltf.node({{"mesh", mesh}});
        folder_.write("b.glb", gltf.binary());
        scene_ = folder_.write(
            "a.scene",
            "<world background='0.25 0.5 1'><object file='a.obj'/><object file='b.glb'/>"
            "<transformation><animation><key time='0' translation='0 0 0'/>"
            "<key time='1' translation='1 0 0'/></animation><object file='a.obj'/>"
            "</transformation><light position='0 0 0' target='0 0 -1' flux='20' aperture='120'/>"
            "<user position='0 0 0' lookat='0 0 -1'/></world>");
    }

    /// `dirt render` while \p failing fail. The cache of the model is there every second time.
    Outcome render(const FailingCalls& failing, bool cached, int64_t* calls = nullptr) {
        return render(scene_, failing, cached, calls);
    }
    Outcome render(const std::string& scene, const FailingCalls& failing, bool cached,
                   int64_t* calls) {
        if (!cached) std::filesystem::remove(folder_ / kCache);
        std::filesystem::remove(folder_ / "a.exr");
        std::filesystem::remove(folder_ / kLog);
        const std::string image = folder_ / "a.exr", log = folder_ / kLog;
        const char* const arguments[] = {
            "dirt",      "render",  scene.c_str(), "--size",      "8x6",    "--spp",    "1",
            "--bounces", "2",       "--tile",      "4",           "--bins", "2",        "--threads",
            "3",         "--quiet", "-o",          image.c_str(), "--log",  log.c_str()};
        CapturedStream out(stdout), err(stderr);
        Outcome run;
        const int64_t made = withFailing(
            failing, [&] { run.status = runProgram((int) std::size(arguments), arguments); });
        if (calls) *calls = made;
        run.out = out.text();
        run.err = err.text();
        return run;
    }

    std::set<std::string> files() const {
        std::set<std::string> names;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_.path()))
            if (entry.is_regular_file())
                names.insert(std::filesystem::relative(entry.path(), folder_.path()).string());
        return names;
    }

    void expectOneLineOrTheImage(const FailingCalls& failing, bool cached) {
        SCOPED_TRACE(std::to_string(failing.first));
        const Outcome run = render(failing, cached);
        std::set<std::string> left = files();
        if (run.status == 0) {
            EXPECT_TRUE(isRight());
        } else {
            EXPECT_EQ(run.status, 2);
            EXPECT_TRUE(run.err.starts_with("dirt: ")) << run.err;
            // Or what the library that writes images has to say.
            EXPECT_TRUE(run.err.find("out of memory") != std::string::npos ||
                        run.err.find("a.exr: cannot write: ") != std::string::npos)
                << run.err;
            EXPECT_EQ(run.err.find('\n'), run.err.size() - 1) << run.err;
            // Unless its name could not be read.
            const std::string log = left.contains(kLog) ? readFile(folder_ / kLog) : "";
            EXPECT_TRUE(log.empty() || log.ends_with(" error: " + run.err.substr(6))) << log;
        }
        // Whole or not there; nothing else.
        for (const std::string& name : left)
            EXPECT_TRUE(before_.contains(name) || (name == "a.exr" && isRight()) ||
                        name == kCache || name == kLog)
                << name;
        failures_ += run.status != 0;
    }

    /// How many calls there are before the scene is looked for. The library that parses the options
    /// ends the process where one of them fails.
    int64_t callsOfOptions() {
        int64_t calls = 0;
        const std::string missing = folder_ / "b.scene";
        EXPECT_EQ(render(missing, {}, false, &calls).status, 2);
        return calls;
    }

    void expectThatItWorks() {
        const Outcome run = render({}, false);
        EXPECT_EQ(run.status, 0) << run.err;
        EXPECT_TRUE(isRight());
    }

    /// The pixels are: a text about the image that its library has no memory for it leaves out.
    bool isRight() const { return readImage(folder_ / "a.exr").pixels == expected_; }

    static constexpr size_t kLarge = 512; ///< bytes
    static constexpr const char *kCache = "a.obj.sbin", *kLog = "log";
    TemporaryFolder folder_;
    std::string scene_;
    std::vector<glm::vec3> expected_;
    std::set<std::string> before_;
    int failures_ = 0;
};

TEST_F(OutOfMemory, AnyCallOfNewMayFail) {
    before_ = files();
    int64_t calls[2] = {};
    ASSERT_EQ(render({}, false).status, 0); // and what is made once in a process is there
    expected_ = readImage(folder_ / "a.exr").pixels;
    ASSERT_TRUE(files().contains(kCache));
    ASSERT_EQ(render({}, false, &calls[0]).status, 0);
    ASSERT_EQ(render({}, true, &calls[1]).status, 0);
    // A prime, so that it falls on different calls of a loop.
    const int64_t first = callsOfOptions(), step = cases(151, 1);
    for (const bool cached : {false, true}) {
        for (int64_t i = first; i < calls[cached]; i += step) {
            expectOneLineOrTheImage({i}, cached);
            if (HasFailure()) FAIL() << i << " of " << calls[cached];
            if ((i - first) % (16 * step) == 0) expectThatItWorks();
        }
    }
    EXPECT_GT(failures_, 10);
}

/// As where a limit is reached: nothing more that is large is to be had, on any thread.
TEST_F(OutOfMemory, AllLargeCallsOfNewMayFailFromOneOn) {
    before_ = files();
    int64_t calls = 0;
    ASSERT_EQ(render({}, false).status, 0);
    expected_ = readImage(folder_ / "a.exr").pixels;
    ASSERT_EQ(render({.least = kLarge}, false, &calls).status, 0);
    ASSERT_GT(calls, 20);
    for (int64_t i = 0; i < calls; i += cases(7, 1)) {
        expectOneLineOrTheImage({i, FailingCalls::kNone, kLarge}, false);
        if (HasFailure()) FAIL() << i << " of " << calls;
    }
    expectThatItWorks();
    EXPECT_GT(failures_, 10);
}

} // namespace
} // namespace dirt::test
