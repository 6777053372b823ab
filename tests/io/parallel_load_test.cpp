// Scenes of many files, read on threads: the same as one after the other.

#include "backend_cpu/thread_pool.h"
#include "core/io/load.h"
#include "tests/io/input_error.h"
#include "tests/io/same_scene.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/write_image.h"

#include <gtest/gtest.h>

namespace dirt {
namespace {

class ParallelLoad : public testing::Test {
protected:
    static constexpr int kObjects = 12;

    ParallelLoad() {
        std::string scene = "<world>";
        for (int i = 0; i < kObjects; ++i) {
            const std::string n = std::to_string(i), m = std::to_string(i % 5);
            writeTexture("t" + m + ".png", i % 5);
            folder_.write("m" + n + ".mtl", "newmtl a\nKd 0 0 0\nmap_Kd t" + m + ".png\nNonsense" +
                                                n + " 1\nnewmtl b\nmap_Kd none" + n +
                                                ".png\nmap_Ks t0.png\nKs .5\n");
            // A denormal, which must not depend on the thread.
            folder_.write("o" + n + ".obj", "mtllib m" + n + ".mtl\nodd" + n + " 1\nv 1e-40 " + n +
                                                " 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl a\nf 1/1 2/1 "
                                                "3/1\nusemtl b\nf 1 2 3\nusemtl c\nf 3 2 1\n");
            scene += "<object file='o" + n + ".obj'/>";
        }
        scene += "<transformation translation='0 0 1'><object file='o3.obj'/></transformation>";
        scene_ = folder_.write("a.scene", scene + "</world>");
    }

    void writeTexture(const std::string& name, int shade) {
        test::writeImage(folder_ / name, 1, 1, 3, {(uint8_t) (shade * 50), 7, 9});
    }

    test::TemporaryFolder folder_;
    std::string scene_;
};

TEST_F(ParallelLoad, GivesTheSameScene) {
    const LoadedScene one = loadScene(scene_);
    EXPECT_EQ(one.scene.textures.size(), 5u);
    EXPECT_EQ(one.scene.scalarTextures.size(), 1u);
    EXPECT_EQ(one.warnings.size(), 2u * kObjects);
    EXPECT_EQ(one.ignored.size(), 2u * kObjects);
    EXPECT_EQ(one.scene.mesh.positions[0].x, 1e-40f);
    ThreadPool threads(4);
    for (int round = 0; round < 20; ++round) {
        size_t calls = 0, last = 0;
        LoadOptions options;
        options.executor = &threads;
        options.progress = [&](size_t done, size_t total) {
            ++calls;
            EXPECT_LE(done, total);
            last = total;
        };
        const LoadedScene many = loadScene(scene_, options);
        EXPECT_EQ(calls, (size_t) kObjects + 5) << "models, then images, each once";
        EXPECT_EQ(last, 5u);
        test::expectSameScene(one, many);
        if (HasFatalFailure()) return;
    }
}

TEST_F(ParallelLoad, TheFirstErrorCounts) {
    for (int i : {2, 5, 9})
        folder_.write("o" + std::to_string(i) + ".obj", "v 0 0 0\nf 1 1 " + std::to_string(i + 7));
    const std::string what = inputError([&] { loadScene(scene_); });
    EXPECT_EQ(what, folder_ / "o2.obj:2: v index 9 is out of range (1 present)");
    ThreadPool threads(4);
    LoadOptions options;
    options.executor = &threads;
    for (int round = 0; round < 50; ++round)
        ASSERT_EQ(inputError([&] { loadScene(scene_, options); }), what);
    options.strict = true;
    folder_.write("o2.obj", "v 0 0 0\nf 1 1 1");
    EXPECT_NE(inputError([&] { loadScene(scene_, options); }).find("o5.obj"), std::string::npos);
}

} // namespace
} // namespace dirt
