// What is more light than there can be, or more than float holds: every pixel stays finite, and it
// is said which number was taken for what.

#include "core/io/image.h"
#include "shaders/shared/radiance.h"
#include "tests/cli/program.h"
#include "tests/support/write_image.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace dirt::test {
namespace {

/// An open box with texture coordinates.
constexpr const char* kBox =
    "mtllib a.mtl\nv -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\nv -1 2 -1\nv 1 2 -1\nv 1 2 1\n"
    "v -1 2 1\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nusemtl m\nf 4/1 3/2 2/3 1/4\nf 5/1 6/2 7/3 8/4\n"
    "f 1/1 2/2 6/3 5/4\nf 4/1 1/2 5/3 8/4\nf 2/1 3/2 7/3 6/4\n";

class Radiance : public testing::Test {
protected:
    void box(const std::string& material, const std::string& background = "0.1 0.1 0.1",
             const std::string& flux = "100") {
        folder_.write("a.mtl", "newmtl m\n" + material);
        folder_.write("a.obj", kBox);
        scene_ = folder_.write(
            "a.scene", "<world background='" + background +
                           "'><camera aperture='50'/><user position='0 1 3.4' lookat='0 1 0'/>"
                           "<light position='0 1.9 0' target='0.1 0 0' flux='" +
                           flux + "' aperture='120'/><object file='a.obj'/></world>");
    }
    /// A texture of one row, three channels.
    void exr(const char* name, const std::vector<float>& values) {
        writeImage(folder_ / name, (int) values.size() / 3, 1, 3, TexelType::float32, values);
    }
    Outcome run(const std::string& command, std::vector<std::string> more = {}) {
        std::vector<std::string> arguments{command, scene_, "--size", "32x24", "--bounces", "8"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return dirt(arguments);
    }
    /// All pixels are finite on every backend, and backends agree. What is said, of the CPU's.
    std::string expectFinite(float most) {
        std::string said;
        for (const char* backend : {"cpu", "embree", "gl"}) {
            const Outcome rendered =
                run("render", {"--backend", backend, "--spp", "4", "-o", folder_ / "a.exr"});
            if (rendered.status == 3) continue;
            EXPECT_EQ(rendered.status, 0) << rendered.err;
            if (said.empty()) said = rendered.err;
            for (const glm::vec3& pixel : readImage(folder_ / "a.exr").pixels)
                for (int c = 0; c < 3; ++c) {
                    EXPECT_GE(pixel[c], 0.0f) << backend;
                    EXPECT_LE(pixel[c], most) << backend;
                }
        }
        for (const char* backends : {"cpu,gl", "cpu,embree"}) {
            const Outcome checked = run("check", {"--backends", backends, "--size", "16x12"});
            if (checked.status == 3) continue;
            EXPECT_EQ(checked.status, 0) << backends << checked.err;
        }
        return said;
    }
    static size_t count(const std::string& text, const std::string& part) {
        size_t found = 0;
        for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
            ++found;
        return found;
    }

    TemporaryFolder folder_;
    std::string scene_;
};

TEST_F(Radiance, ReflectancesAboveOneAreOne) {
    for (const char* lines :
         {"Kd 2 2 2\n", "Kd 1e20 1e20 1e20\n", "Kd .5 .5 .5\nKs 2 2 2\nNs 30\n"}) {
        box(lines);
        const std::string said = expectFinite(1e4f);
        EXPECT_EQ(count(said, "warning"), 1u) << said;
        EXPECT_EQ(count(said, "is above 1, and taken for it"), 1u) << said;
        const Outcome strict = run("render", {"--strict", "-o", folder_ / "a.exr"});
        EXPECT_EQ(strict.status, 2);
    }
}

TEST_F(Radiance, MapsWithOtherNumbersAreSaid) {
    const float nan = std::nanf(""), inf = std::numeric_limits<float>::infinity();
    exr("big.exr", {1e20f, 2.0f, 0.5f, 1.0f, 1.0f, 1.0f});
    exr("bad.exr", {nan, inf, -1.0f, -inf, 0.5f, 0.25f});
    box("Kd 1 1 1\nmap_Kd big.exr\n");
    std::string said = expectFinite(1e4f);
    EXPECT_EQ(count(said, "warning"), 1u) << said;
    EXPECT_EQ(count(said,
                    "texture 'big.exr': has numbers from 0.5 to 1e+20: those below 0 are taken "
                    "for 0, those above 1 for 1"),
              1u)
        << said;
    // Of numbers that are no radiance either, in the same line.
    exr("huge.exr", {1e30f, 2e38f, 3e38f});
    for (const auto& [name, how] :
         {std::pair{"bad.exr",
                    "4 numbers are not from 0 to 7.92282e+28: the nearest is taken, for a "
                    "NaN 0; has numbers from 0 to 7.92282e+28: those below 0 are taken "
                    "for 0, those above 1 for 1"},
          std::pair{"huge.exr",
                    "3 numbers are not from 0 to 7.92282e+28: the nearest is taken, for "
                    "a NaN 0; has numbers from 7.92282e+28 to 7.92282e+28: those below "
                    "0 are taken for 0, those above 1 for 1"}}) {
        box("Kd 1 1 1\nmap_Kd " + std::string(name) + "\n");
        said = expectFinite(1e4f);
        EXPECT_EQ(count(said, "warning"), 1u) << said;
        EXPECT_EQ(count(said, "texture '" + std::string(name) + "': " + how), 1u) << said;
    }
    // The light's radiance is what it is.
    box("Kd 0.5 0.5 0.5\nKe 1 1 1\nmap_Ke big.exr\n");
    said = expectFinite(kMostRadiance);
    EXPECT_EQ(count(said, "warning"), 0u) << said;
}

TEST_F(Radiance, MapsOfDataWithOtherNumbersAreSaid) {
    const float nan = std::nanf(""), inf = std::numeric_limits<float>::infinity();
    exr("bad.exr", {nan, nan, nan, inf, inf, inf, -2.0f, -2.0f, -2.0f, 0.5f, 0.5f, 0.5f});
    for (const char* map : {"map_Pr", "map_Pm", "map_Ks", "map_Ns"}) {
        box("Kd 0.5 0.5 0.5\nKs 0.5 0.5 0.5\nPr 0.5\n" + std::string(map) + " bad.exr\n");
        scene_ = folder_ / "a.obj";
        const std::string said = expectFinite(1e4f);
        EXPECT_EQ(count(said, "warning"), 1u) << map << said;
        EXPECT_EQ(count(said, "numbers are not finite"), 1u) << map << said;
        EXPECT_EQ(count(said, "those below 0 are taken for 0, those above 1 for 1"), 1u)
            << map << said;
    }
    box("Kd 0.5 0.5 0.5\nmap_bump bad.exr\n");
    EXPECT_EQ(count(expectFinite(1e4f), "numbers are not finite"), 1u);
}

TEST_F(Radiance, BeyondFloatIsClampedAndCounted) {
    const float most = kMostRadiance;
    box("Kd 0.9 0.9 0.9\n", "3.4e38 3.4e38 3.4e38");
    std::string said = expectFinite(most);
    EXPECT_EQ(count(said, ":1: background is above 7.92282e+28, and taken for it"), 1u) << said;
    EXPECT_EQ(count(said, "samples of pixels is beyond what is kept, and was clamped"), 1u) << said;

    box("Kd 0.9 0.9 0.9\nKe 1e38 1 0\n");
    said = expectFinite(most);
    EXPECT_EQ(count(said, "Ke 1e+38 is above 7.92282e+28, and taken for it"), 1u) << said;

    box("Kd 0.9 0.9 0.9\n", "0 0 0", "1e300");
    for (const char* backend : {"cpu", "gl"}) {
        const Outcome rendered =
            run("render", {"--json", "--backend", backend, "--spp", "2", "-o", folder_ / "a.exr"});
        if (rendered.status == 3) continue;
        ASSERT_EQ(rendered.status, 0) << rendered.err;
        const auto json = nlohmann::json::parse(rendered.out);
        EXPECT_GT(json["clamped"], 20);
        EXPECT_LE(json["clamped"], 32 * 24 * 2);
        EXPECT_NE(rendered.err.find("radiance of " + json["clamped"].dump() + " of 1536 samples"),
                  std::string::npos)
            << rendered.err;
    }
    expectFinite(most);

    box("Kd 0.9 0.9 0.9\n");
    const Outcome ordinary = run("render", {"--json", "--spp", "1", "-o", folder_ / "a.exr"});
    EXPECT_EQ(nlohmann::json::parse(ordinary.out)["clamped"], 0);
    EXPECT_EQ(ordinary.err.find("clamped"), std::string::npos);
}

} // namespace
} // namespace dirt::test
