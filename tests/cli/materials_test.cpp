// What MTL files look like in the program: the defaults of exporters, --materials, and what info
// says of both.

#include "core/io/image.h"
#include "tests/cli/program.h"
#include "tests/support/write_image.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace dirt::test {
namespace {

using nlohmann::json;

/// A quad whose left half a texture makes red, whose right half blue.
class Exporter : public testing::Test {
protected:
    void SetUp() override { writeImage(folder_ / "two.png", 2, 1, 3, {255, 0, 0, 0, 0, 255}); }

    std::string model(const std::string& material) {
        folder_.write("a.mtl", "newmtl m\n" + material + "map_Kd two.png\n");
        return folder_.write("a.obj", "mtllib a.mtl\nusemtl m\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\n"
                                      "v -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 1\n"
                                      "f 1/1/1 2/2/1 3/3/1 4/4/1\n");
    }

    /// Seen from its front, the light of the automatic camera on it.
    Image render(const std::string& model, std::vector<std::string> more = {}) {
        std::vector<std::string> arguments{
            "render",   model,   "--size", "32x24", "--spp",   "16", "--eye",          "0,0,3",
            "--target", "0,0,0", "--fov",  "30",    "--quiet", "-o", folder_ / "a.exr"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Outcome run = dirt(arguments);
        EXPECT_EQ(run.status, 0) << run.err;
        return readImage(folder_ / "a.exr");
    }

    /// The mean over the middle of the left or right half.
    static glm::vec3 half(const Image& image, int from) {
        glm::vec3 sum(0.0f);
        for (int y = 8; y < 16; ++y)
            for (int x = from; x < from + 6; ++x)
                sum += image.pixels[(size_t) (y * image.width + x)];
        return sum / 48.0f;
    }

    TemporaryFolder folder_;
};

/// Kd is the colour; Ks adds a highlight at most.
TEST_F(Exporter, DefaultsLeaveTheTextureVisible) {
    const char* const defaults[] = {
        "Kd 1 1 1\nKs 1 1 1\nNs 0\nTr 1\nillum 2\n",      // MeshLab
        "Kd 1 1 1\nKs .5 .5 .5\nNs 250\nd 1\nillum 2\n",  // Blender from 2.8 on
        "Kd 1 1 1\nKs .5 .5 .5\nNs 96.078431\nillum 2\n", // Blender 2.7
        "Kd 1 1 1\nKs 1 1 1\nNs 30\nd 1\n",               // Wings3D: Ks like Kd
        "Kd 1 1 1\nKs 0 0 0\nNs 0\nillum 2\n",            // matte
    };
    for (const char* material : defaults) {
        const Image image = render(model(material));
        const glm::vec3 left = half(image, 7), right = half(image, 19);
        EXPECT_GT(left.x, 3.0f * left.y) << material;
        EXPECT_GT(left.x, 3.0f * left.z) << material;
        EXPECT_GT(right.z, 3.0f * right.x) << material;
        EXPECT_GT(right.z, 3.0f * right.y) << material;
    }
    // In the demo's convention the first is a mirror of nothing but the background.
    const glm::vec3 left = half(render(model(defaults[0]), {"--materials", "demo"}), 7);
    EXPECT_LT(left.x, 1.5f * left.z);
}

/// Metals reflect Kd, mirrors that repeat Kd as Ka reflect Ks; all under a white sky, which nothing
/// else lights.
TEST_F(Exporter, MirrorsShowWhatTheyReflect) {
    const auto middle = [&](const std::string& material) {
        folder_.write("a.mtl", "newmtl m\n" + material);
        folder_.write("a.obj", "mtllib a.mtl\nusemtl m\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n"
                               "f 1 2 3 4\n");
        const Image image = render(folder_.write(
            "a.scene", "<world background='1 1 1' materials='wavefront' microfacet_model='ggx'>"
                       "<object file='a.obj'/></world>"));
        return image.pixels[(size_t) (12 * image.width + 16)];
    };
    // Schlick's term (1 - c)^5 is below 1e-9 within 0.05 of the axis.
    const float rounding = 1e-5f;
    const glm::vec3 gold = middle("Kd .9 .6 .2\nNs 1000\nillum 3\n");
    EXPECT_NEAR(gold.x, 0.9f, rounding);
    EXPECT_NEAR(gold.y, 0.6f, rounding);
    EXPECT_NEAR(gold.z, 0.2f, rounding);
    const glm::vec3 pure = middle("Kd .9 .6 .2\nPr 0\nPm 1\n");
    EXPECT_NEAR(pure.y, 0.6f, rounding);
    const glm::vec3 mirror = middle("Ka 0 0 0\nKd 0 0 0\nKs .75 .75 .75\nNs 1000\nillum 5\n");
    EXPECT_NEAR(mirror.x, 0.75f, rounding);
    const glm::vec3 glaze = middle("Kd 0 0 0\nKs .5 .5 .5\nNs 1000\nillum 2\n");
    EXPECT_NEAR(glaze.x, 0.04f, rounding);
}

TEST_F(Exporter, InfoSaysWhatWasTakenAndWhy) {
    const std::string file = model("Ks 1 1 1\n");
    const Outcome text = dirt({"info", file, "--size", "32x24"});
    EXPECT_NE(text.out.find("a.mtl: wavefront, as it is of a model by itself\n"), std::string::npos)
        << text.out;
    const auto files = [&](std::vector<std::string> more) {
        more.insert(more.begin(), {"info", "--json", "--size", "32x24"});
        return json::parse(dirt(more).out)["material_files"];
    };
    EXPECT_EQ(files({file, "--materials", "demo"}),
              json::array({{{"file", folder_ / "a.mtl"},
                            {"convention", "demo"},
                            {"reason", "--materials says so"}}}));
    const std::string scene = folder_.write("a.scene", "<world materials='wavefront'>"
                                                       "<object file='a.obj'/></world>");
    EXPECT_EQ(files({scene})[0]["reason"], "<world> says so");
    EXPECT_EQ(files({folder_.write("bare.obj", kTriangleObj)}), json::array());
}

TEST_F(Exporter, HalfTransparentIsSaid) {
    const std::string file = model("Kd 0 1 0\nd 0.4\n");
    const Outcome run =
        dirt({"render", file, "--size", "8x8", "--spp", "1", "-o", folder_ / "a.png"});
    EXPECT_EQ(run.status, 0);
    EXPECT_NE(run.err.find("material 'm' has d 0.4"), std::string::npos) << run.err;
}

TEST_F(Exporter, UnknownConventionIsRefused) {
    const Outcome run = dirt({"info", model(""), "--materials", "phong"});
    EXPECT_EQ(run.status, 2);
    EXPECT_NE(run.err.find("--materials"), std::string::npos);
}

} // namespace
} // namespace dirt::test
