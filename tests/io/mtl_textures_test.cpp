// What the textures of MTL materials become, and how they are sampled, in both conventions.

#include "core/io/load.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/write_image.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace dirt {
namespace {

using Bytes = std::vector<uint8_t>;
using Names = std::vector<std::string>;

class MtlTextures : public testing::Test {
protected:
    /// A PNG file of one row.
    void image(const std::string& name, int channels, const Bytes& texels) {
        test::writeImage(folder_ / name, (int) texels.size() / channels, 1, channels, texels);
    }

    const Material& load(const std::string& lines,
                         MaterialConvention convention = MaterialConvention::wavefront) {
        folder_.write("a.mtl", "newmtl m\n" + lines);
        LoadOptions options;
        options.materials = convention;
        loaded_ = loadScene(folder_.write("a.obj", "mtllib a.mtl\nusemtl m\nv 0 0 0\nv 1 0 0\n"
                                                   "v 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n"
                                                   "f 1/1 2/2 3/3\n"),
                            options);
        return loaded_.scene.materials.at(0);
    }

    const ScalarTexture& scalars(uint32_t map) const {
        return loaded_.scene.scalarTextures.at(map);
    }
    const Texture& texture(uint32_t map) const { return loaded_.scene.textures.at(map); }

    static constexpr glm::vec2 kMiddle{0.5f, 0.5f};
    test::TemporaryFolder folder_;
    LoadedScene loaded_;
};

TEST_F(MtlTextures, WavefrontTexturesReplaceNumbers) {
    image("half.png", 1, {51});
    const Material roughMap = load("Pr 0.1\nNs 900\nmap_Pr half.png\n");
    EXPECT_EQ(roughMap.roughness, 1.0f);
    EXPECT_EQ(scalars(roughMap.roughnessMap).sample(kMiddle), 0.2f);
    const Material exponent = load("map_Ns half.png\n");
    EXPECT_EQ(exponent.roughness, 1.0f);
    EXPECT_EQ(scalars(exponent.roughnessMap).sample(kMiddle), 0.2f);

    const Material metal = load("Pm 0\nKs .5 .5 .5\nmap_Pm half.png\n");
    EXPECT_EQ(metal.metallic, 1.0f);
    EXPECT_EQ(metal.reflectance, 0.04f) << "where it is no metal";
    EXPECT_EQ(scalars(metal.metallicMap).sample(kMiddle), 0.2f);

    const Material specular = load("Ks 0 0 0\nmap_Ks half.png\n");
    EXPECT_EQ(specular.reflectance, 0.08f);
    EXPECT_EQ(scalars(specular.reflectanceMap).sample(kMiddle), 0.2f);
    const Material both = load("map_Ks half.png\nmap_Pm half.png\n");
    EXPECT_EQ(both.reflectance, 0.08f);
    EXPECT_NE(both.metallicMap, kNoTexture);
    EXPECT_TRUE(loaded_.ignored.empty());
    EXPECT_TRUE(loaded_.warnings.empty());
}

TEST_F(MtlTextures, WavefrontNamesTexturesThatOthersReplace) {
    image("half.png", 1, {51});
    image("other.png", 1, {255});
    const Material rough = load("map_Pr half.png\nmap_Ns other.png\n");
    EXPECT_EQ(scalars(rough.roughnessMap).sample(kMiddle), 0.2f);
    EXPECT_EQ(loaded_.ignored, Names{"MTL map_Ns beside map_Pr"});
    const Material metal = load("Pm 1\nmap_Ks half.png\n");
    EXPECT_EQ(metal.reflectanceMap, kNoTexture);
    EXPECT_EQ(metal.reflectance, 1.0f);
    EXPECT_EQ(loaded_.ignored, Names{"MTL map_Ks of a metal"});
}

/// One of Maya's IFF, with a tile that unpacks to more than it says: the library's reader of these
/// writes beyond its buffer.
TEST_F(MtlTextures, ImagesThatAreNotReadAreReplaced) {
    const auto number = [](uint32_t value) {
        return std::string{(char) (value >> 24), (char) (value >> 16), (char) (value >> 8),
                           (char) value};
    };
    const auto chunk = [&](const char* name, const std::string& content) {
        return name + number((uint32_t) content.size()) + content;
    };
    const std::string header = number(16) + number(16) + std::string("\0\1\0\1\0\0\0\3", 8) +
                               std::string("\0\1\0\1\0\0\0\1\0\0\0\0\0\0\0\0", 16);
    const std::string tile = std::string("\0\0\0\0\0\017\0\017", 8) + std::string(1016, '\377');
    folder_.write("iff.png", chunk("FOR4", "CIMG" + chunk("TBHD", header) +
                                               chunk("FOR4", "TBMP" + chunk("RGBA", tile))));
    for (const auto convention : {MaterialConvention::wavefront, MaterialConvention::demo}) {
        const Material plain = load("Kd 1 0 0\nmap_Kd iff.png\n", convention);
        EXPECT_EQ(plain.diffuseMap, kNoTexture);
        EXPECT_EQ(plain.diffuse, Material().diffuse);
        ASSERT_EQ(loaded_.warnings.size(), 1u);
        EXPECT_EQ(loaded_.warnings[0].kind, WarningKind::unusableTexture);
        EXPECT_NE(loaded_.warnings[0].text.find("is none of the images that are read: PNG, JPEG"),
                  std::string::npos)
            << loaded_.warnings[0].text;
    }
}

TEST_F(MtlTextures, WavefrontKeepsNumbersOfMissingTextures) {
    const Material a = load("Pr 0.5\nPm 0.25\nKs .5 .5 .5\nmap_Pr none.png\n"
                            "map_Pm other.png\nmap_Ks third.png\n");
    EXPECT_EQ(a.roughness, 0.25f);
    EXPECT_EQ(a.metallic, 0.25f);
    EXPECT_EQ(a.reflectance, 0.04f + 0.96f * 0.25f);
    EXPECT_EQ(a.roughnessMap & a.metallicMap & a.reflectanceMap, kNoTexture);
    EXPECT_EQ(loaded_.warnings.size(), 3u);
}

TEST_F(MtlTextures, EmissionIsTheTextureInWavefront) {
    image("half.png", 3, {255, 255, 255});
    EXPECT_EQ(load("Ke 0 0 0\nmap_Ke half.png\n").emission, glm::vec3(1));
    EXPECT_EQ(load("Ke 1 5 2\nmap_Ke half.png\n").emission, glm::vec3(5));
    EXPECT_EQ(load("Ke 1 5 2\nmap_Ke none.png\n").emission, glm::vec3(0));
    EXPECT_EQ(load("Ke 1 5 2\nmap_Ke half.png\n", MaterialConvention::demo).emission,
              glm::vec3(1, 5, 2));
    EXPECT_EQ(load("Ke 1 5 2\nmap_Ke none.png\n", MaterialConvention::demo).emission,
              glm::vec3(1, 5, 2));
}

TEST_F(MtlTextures, DemoTexturesMultiplyAndPhysicalOnesAreNamed) {
    image("half.png", 3, {51, 255, 255});
    const Material a = load("Ks .5\nNs 127\nmap_Ks half.png\nmap_Pr half.png\nmap_Pm half.png\n"
                            "map_Ns half.png\n",
                            MaterialConvention::demo);
    EXPECT_EQ(a.reflectance, 0.5f);
    EXPECT_EQ(scalars(a.reflectanceMap).sample(kMiddle), 0.2f) << "the first channel";
    EXPECT_EQ(a.roughness, 0.0f);
    EXPECT_EQ(a.roughnessMap & a.metallicMap, kNoTexture);
    EXPECT_EQ(loaded_.ignored, (Names{"MTL map_Ns", "MTL map_Pr", "MTL map_Pm"}));
}

TEST_F(MtlTextures, ChannelsAreTakenAsImfchanSays) {
    image("all.png", 4, {51, 102, 153, 204});
    const auto sampled = [&](const std::string& option, MaterialConvention convention) {
        const Material a = load("Ks 1 1 1\nmap_Ks " + option + "all.png\n", convention);
        return scalars(a.reflectanceMap).sample(kMiddle);
    };
    for (const auto convention : {MaterialConvention::demo, MaterialConvention::wavefront}) {
        EXPECT_EQ(sampled("-imfchan r ", convention), 0.2f);
        EXPECT_EQ(sampled("-imfchan g ", convention), 0.4f);
        EXPECT_EQ(sampled("-imfchan b ", convention), 0.6f);
        EXPECT_EQ(sampled("-imfchan m ", convention), 0.8f);
    }
    // Rec.709, of three channels that are each rounded once: within some units of 2^-24.
    const float luminance = 0.2126f * 0.2f + 0.7152f * 0.4f + 0.0722f * 0.6f;
    EXPECT_NEAR(sampled("-imfchan l ", MaterialConvention::demo), luminance, 1e-6f);
    EXPECT_NEAR(sampled("", MaterialConvention::wavefront), luminance, 1e-6f)
        << "the format's default";
    EXPECT_EQ(sampled("", MaterialConvention::demo), 0.2f);
    // An alpha that cuts nothing out is no opacity, but where it is asked for.
    const Material asked = load("map_d -imfchan m all.png\n");
    EXPECT_EQ(scalars(asked.opacityMap).sample(kMiddle), 0.8f);
}

TEST_F(MtlTextures, ScalesOffsetsAndClampsAreThoseOfEachStatement) {
    image("two.png", 3, {255, 0, 0, 0, 0, 255});
    for (const auto convention : {MaterialConvention::demo, MaterialConvention::wavefront}) {
        const Material a = load("map_Kd -s 2 3 1 -o 0.25 0.5 two.png\nmap_Ks -clamp on two.png\n"
                                "map_d two.png\n",
                                convention);
        const TextureSampling moved = texture(a.diffuseMap).sampling();
        EXPECT_TRUE(moved.transformed);
        EXPECT_EQ(moved.imageCoordinates({0.5f, 0.25f}), glm::vec2(1.25f, 1.25f));
        EXPECT_EQ(moved.wrapU, Wrap::repeat);
        const TextureSampling clamped = scalars(a.reflectanceMap).sampling();
        EXPECT_EQ(clamped.wrapU, Wrap::clamp);
        EXPECT_EQ(clamped.wrapV, Wrap::clamp);
        EXPECT_FALSE(clamped.transformed);
        EXPECT_EQ(scalars(a.opacityMap).sampling(), TextureSampling());
        // u = 0: the image's 1/4, in the middle of its first texel; the second is 1/4 farther.
        EXPECT_EQ(texture(a.diffuseMap).sample({0.0f, 0.0f}), glm::vec3(1, 0, 0));
        EXPECT_EQ(texture(a.diffuseMap).sample({0.25f, 0.0f}), glm::vec3(0, 0, 1));
        EXPECT_TRUE(loaded_.ignored.empty());
    }
}

TEST_F(MtlTextures, ColoursAreLinearWhereTheySaySo) {
    image("grey.png", 3, {51, 51, 51});
    EXPECT_EQ(texture(load("map_Kd -colorspace linear grey.png\n").diffuseMap).sample(kMiddle),
              glm::vec3(0.2f));
    const float decoded = Texture::decodedBytes(TexelEncoding::srgb)[51];
    EXPECT_EQ(texture(load("map_Kd -colorspace sRGB grey.png\n").diffuseMap).sample(kMiddle),
              glm::vec3(decoded));
    EXPECT_EQ(texture(load("map_Kd grey.png\n").diffuseMap).sample(kMiddle), glm::vec3(decoded));
}

TEST_F(MtlTextures, NormalMapsAreOfNormAndOfBumpsThatAreNormals) {
    image("normals.png", 3, {128, 128, 255, 190, 128, 237});
    image("heights.png", 3, {128, 128, 128, 200, 200, 200});
    image("wood.png", 3, {150, 110, 70, 120, 80, 50});
    for (const auto convention : {MaterialConvention::demo, MaterialConvention::wavefront})
        for (const char* key : {"norm", "map_Kn"}) {
            const Material a = load(key + std::string(" -bm 0.5 normals.png\n"), convention);
            EXPECT_EQ(texture(a.normalMap).sample({0.25f, 0.5f}).z, 1.0f);
            EXPECT_EQ(texture(a.normalMap).sample({0.25f, 0.5f}).x, 128.0f / 255.0f) << "linear";
            EXPECT_EQ(a.normalScale, 0.5f);
            EXPECT_EQ(a.bumpMap, kNoTexture);
        }
    const Material normals = load("map_Bump -bm 2 normals.png\n");
    EXPECT_NE(normals.normalMap, kNoTexture);
    EXPECT_EQ(normals.normalScale, 2.0f);
    EXPECT_EQ(normals.bumpMap, kNoTexture);
    for (const char* image : {"heights.png", "wood.png"}) {
        const Material heights = load(std::string("bump -bm 2 ") + image + "\n");
        EXPECT_EQ(heights.normalMap, kNoTexture) << image;
        EXPECT_NE(heights.bumpMap, kNoTexture) << image;
        EXPECT_EQ(heights.bumpScale, 2.0f);
    }
    const Material demo = load("map_bump normals.png\n", MaterialConvention::demo);
    EXPECT_NE(demo.bumpMap, kNoTexture) << "as ever";
    EXPECT_EQ(demo.normalMap, kNoTexture);
    load("norm normals.png\nmap_bump heights.png\n");
    EXPECT_EQ(loaded_.ignored, Names{"MTL map_bump beside norm"});
}

/// Exporters write paths of the machine that they run on.
TEST_F(MtlTextures, WavefrontLooksForTheNameAloneToo) {
    image("wood.png", 3, {51, 51, 51});
    for (const char* path :
         {"C:\\Users\\me\\maps\\wood.png", "/home/me/Wood.PNG", "wood.png", "\"wood.png\""}) {
        EXPECT_NE(load(std::string("map_Kd ") + path + "\n").diffuseMap, kNoTexture) << path;
        EXPECT_TRUE(loaded_.warnings.empty());
    }
    EXPECT_EQ(load("map_Kd C:\\maps\\wood.png\n", MaterialConvention::demo).diffuseMap, kNoTexture);
    EXPECT_EQ(loaded_.warnings.size(), 1u);
}

} // namespace
} // namespace dirt
