// What the numbers of an MTL material mean in each convention.

#include "core/io/mtl_material.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace dirt {
namespace {

class MtlMeaning : public testing::Test {
protected:
    MtlMaterial read(const std::string& lines) {
        return readMtl(folder_.write("test.mtl", "newmtl a\n" + lines)).materials.at(0);
    }
    Material demo(const std::string& lines) {
        return materialOf(read(lines), MaterialConvention::demo);
    }
    Material wavefront(const std::string& lines) {
        return materialOf(read(lines), MaterialConvention::wavefront);
    }
    std::vector<std::string> ignored(const std::string& lines, MaterialConvention convention) {
        LoadReport report;
        reportIgnored(read(lines), convention, report);
        return report.ignored();
    }

    test::TemporaryFolder folder_;
};

TEST_F(MtlMeaning, DemoTakesKsAsReflectanceAndNsTo127) {
    const Material a = demo("Kd .1 .2 .3\nKe 1 2 3\nKs 0.25 0.5 1\nNs 63.5\nmetallic 1\nd 0.25\n");
    EXPECT_EQ(a.name, "a");
    EXPECT_EQ(a.diffuse, glm::vec3(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(a.emission, glm::vec3(1, 2, 3));
    EXPECT_EQ(a.reflectance, 0.25f);
    EXPECT_EQ(a.roughness, 0.5f);
    EXPECT_EQ(a.metallic, 1.0f);
    EXPECT_EQ(a.opacity, 0.25f);
    const Material beyond = demo("Ks 2\nNs 900\nmetallic 7\nd 1.5\n");
    EXPECT_EQ(beyond.reflectance, 1.0f);
    EXPECT_EQ(beyond.roughness, 0.0f);
    EXPECT_EQ(beyond.metallic, 1.0f);
    EXPECT_EQ(beyond.opacity, 1.0f);
    const Material none = demo("");
    EXPECT_EQ(none.diffuse, Material().diffuse);
    EXPECT_EQ(none.reflectance, 0.0f);
    EXPECT_EQ(none.roughness, 1.0f);
    EXPECT_EQ(none.bumpScale, 1.0f);
    const Material other = demo("illum 3\nTr 0.9\nPr 0\nPm 1\nbump -bm 4 b.png\n");
    EXPECT_EQ(other.reflectance, 0.0f);
    EXPECT_EQ(other.metallic, 0.0f);
    EXPECT_EQ(other.roughness, 1.0f);
    EXPECT_EQ(other.opacity, 1.0f);
    EXPECT_EQ(other.bumpScale, 4.0f);
}

TEST_F(MtlMeaning, WavefrontTakesNsTo1000AndKsAsAHighlight) {
    const Material blender = wavefront("Kd .8 .4 .2\nKs .5 .5 .5\nNs 250\nillum 2\n");
    EXPECT_EQ(blender.diffuse, glm::vec3(0.8f, 0.4f, 0.2f));
    EXPECT_EQ(blender.roughness, 0.25f); // (1 - sqrt(1/4))^2
    EXPECT_EQ(blender.reflectance, 0.08f * 0.5f);
    EXPECT_EQ(blender.metallic, 0.0f);
    const Material meshlab = wavefront("Ks 1 1 1\nNs 0\nillum 2\n");
    EXPECT_EQ(meshlab.roughness, 1.0f);
    EXPECT_EQ(meshlab.reflectance, 0.08f);
    EXPECT_FLOAT_EQ(wavefront("Ks 0.3 0.6 0.9\n").reflectance, 0.08f * 0.6f);
    EXPECT_EQ(wavefront("Ks 9 9 9\n").reflectance, 0.08f);
    EXPECT_EQ(wavefront("Ns 1000\n").roughness, 0.0f);
    EXPECT_EQ(wavefront("Ns 1e9\n").roughness, 0.0f);
    const float r = 1.0f - std::sqrt(0.1f);
    EXPECT_EQ(wavefront("Ns 100\n").roughness, r * r);
}

TEST_F(MtlMeaning, WavefrontKnowsWhatIsNotSaid) {
    const Material dull = wavefront("");
    EXPECT_EQ(dull.diffuse, Material().diffuse);
    EXPECT_EQ(dull.reflectance, 0.0f);
    EXPECT_EQ(dull.roughness, 1.0f);
    for (const char* model : {"illum 0\n", "illum 1\n", "illum 9\n", "illum 10\n", "illum 77\n"}) {
        EXPECT_EQ(wavefront(model).reflectance, 0.0f) << model;
        EXPECT_EQ(wavefront(model).roughness, 1.0f) << model;
    }
    const Material highlight = wavefront("illum 2\n");
    EXPECT_EQ(highlight.reflectance, 0.08f);
    EXPECT_EQ(highlight.roughness, 0.0f);
    EXPECT_EQ(highlight.metallic, 0.0f);
    // What is said counts whatever the model.
    EXPECT_EQ(wavefront("illum 1\nKs .5 .5 .5\nNs 250\n").reflectance, 0.04f);
}

TEST_F(MtlMeaning, WavefrontTakesReflectingModelsForMetals) {
    for (const char* model : {"3", "4", "5", "6", "7", "8"}) {
        const std::string illum = std::string("illum ") + model + "\n";
        const Material metal = wavefront(illum + "Kd .9 .6 .2\nNs 1000\n");
        EXPECT_EQ(metal.metallic, 1.0f) << model;
        EXPECT_EQ(metal.reflectance, 1.0f) << model;
        EXPECT_EQ(metal.roughness, 0.0f) << model;
        const Material half = wavefront(illum + "Ka .5 .5 .5\nKs .5 .5 .5\n");
        EXPECT_EQ(half.metallic, 0.5f) << model;
        EXPECT_EQ(half.reflectance, 0.04f + (1.0f - 0.04f) * 0.5f) << model;
    }
    for (const char* model : {"0", "1", "2", "9", "10"})
        EXPECT_EQ(wavefront(std::string("Ka 1 1 1\nillum ") + model + "\n").metallic, 0.0f)
            << model;
    EXPECT_EQ(wavefront("illum 3\nKa 4 4 4\n").metallic, 1.0f);
}

/// As the Cornell boxes of McGuire and Cardenas have their mirrors.
TEST_F(MtlMeaning, WavefrontKnowsAMirrorWhoseKaIsAmbientLight) {
    const Material mirror =
        wavefront("Ka .01 .01 .01\nKd .01 .01 .01\nKs .95 .95 .95\nNs 1000\nillum 5\n");
    EXPECT_FLOAT_EQ(mirror.reflectance, 0.95f);
    EXPECT_EQ(mirror.metallic, 0.0f);
    EXPECT_EQ(mirror.roughness, 0.0f);
    // As Blender writes a white metal.
    const Material metal = wavefront("Ka 1 1 1\nKd 1 1 1\nKs .5 .5 .5\nillum 3\n");
    EXPECT_EQ(metal.metallic, 1.0f);
    EXPECT_EQ(metal.reflectance, 1.0f);
    EXPECT_EQ(wavefront("Ka .1 .1 .1\nKd .1 .1 .1\nKs 1 1 1\nillum 3\nPm .5\n").metallic, 0.5f);
}

TEST_F(MtlMeaning, WavefrontPrefersThePhysicalKeys) {
    const Material a = wavefront("Ns 250\nPr 0.7\nPm 0.25\nKs .5 .5 .5\nillum 3\n");
    EXPECT_EQ(a.roughness, 0.7f * 0.7f);
    EXPECT_EQ(a.metallic, 0.25f);
    EXPECT_EQ(a.reflectance, 0.04f + 0.96f * 0.25f);
    const Material beyond = wavefront("Pr 7\nPm 3\n");
    EXPECT_EQ(beyond.roughness, 1.0f);
    EXPECT_EQ(beyond.metallic, 1.0f);
}

TEST_F(MtlMeaning, WavefrontTakesTrForWhatDLeavesOut) {
    EXPECT_EQ(wavefront("d 0.4\n").opacity, 0.4f);
    EXPECT_EQ(wavefront("d 3\n").opacity, 1.0f);
    EXPECT_EQ(wavefront("Tr 0\n").opacity, 1.0f);
    EXPECT_EQ(wavefront("Tr 0.75\n").opacity, 0.25f);
    EXPECT_EQ(wavefront("Tr 1\n").opacity, 1.0f) << "as MeshLab writes all that is opaque";
    EXPECT_EQ(wavefront("Tr 1\nd 1\n").opacity, 1.0f);
    EXPECT_EQ(wavefront("d 0.4\nTr 0\n").opacity, 0.4f);
}

TEST_F(MtlMeaning, NamesWhatHasNoEffect) {
    using Names = std::vector<std::string>;
    const std::string all = "Ka 1 1 1\nillum 2\nTr 0\nPr 0\nPm 0\nmetallic 1\nmap_Ns n.png\n"
                            "map_Pr r.png\nmap_Pm m.png\nmap_Kd d.png\nnorm n.png\n";
    EXPECT_EQ(ignored(all, MaterialConvention::demo),
              (Names{"MTL Ka", "MTL illum", "MTL Tr", "MTL Pr", "MTL Pm", "MTL map_Ns",
                     "MTL map_Pr", "MTL map_Pm"}));
    EXPECT_EQ(ignored(all, MaterialConvention::wavefront), (Names{"MTL Ka", "MTL metallic"}));
    EXPECT_EQ(ignored("Ka 1 1 1\nillum 3\n", MaterialConvention::wavefront), Names{});
    EXPECT_EQ(ignored("illum 7\n", MaterialConvention::wavefront),
              Names{"MTL illum 7, its transparency"});
    EXPECT_EQ(ignored("illum 10\n", MaterialConvention::wavefront), Names{"MTL illum 10"});
    EXPECT_EQ(ignored("Tr 1\n", MaterialConvention::wavefront), Names{"MTL Tr 1, taken as opaque"});
    EXPECT_EQ(ignored("Tr 1\nd 1\n", MaterialConvention::wavefront),
              Names{"MTL Tr, which contradicts d"});
    EXPECT_EQ(ignored("Tr 0.6\nd 0.4\n", MaterialConvention::wavefront), Names{});
}

} // namespace
} // namespace dirt
