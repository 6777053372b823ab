// Materials of glTF files: samplers, transforms, normal maps, colours of vertices, extensions.

#include "shaders/shared/radiance.h"
#include "tests/io/gltf_fixture.h"

#include <numbers>

namespace dirt {
namespace {

/// A triangle with texture coordinates and a material that has a texture.
GltfWriter mapped(const Json& info = {{"index", 0}}) {
    GltfWriter writer;
    const size_t mesh = writer.triangle();
    Json& primitive = writer.json["meshes"][mesh]["primitives"][0];
    primitive["attributes"]["TEXCOORD_0"] = writer.vec2({0, 0, 1, 0, 0, 1});
    primitive["material"] = 0;
    writer.json["images"] = Json::array({{{"uri", "two.png"}}});
    writer.json["textures"] = Json::array({{{"source", 0}}});
    writer.json["materials"] = Json::array(
        {{{"pbrMetallicRoughness", {{"baseColorTexture", info}, {"metallicFactor", 0}}}}});
    return writer;
}

const glm::vec3 kRed(1, 0, 0), kBlue(0, 0, 1);

class GltfMaterial : public Gltf {
protected:
    GltfMaterial() { twoColours("two.png", {255, 0, 0, 255}, {0, 0, 255, 255}); }

    glm::vec3 diffuse(const GltfWriter& writer, glm::vec2 uv) {
        const Scene scene = load(writer).scene;
        return scene.textures.at(scene.materials.at(0).diffuseMap).sample(uv);
    }
    /// Of a triangle's only material.
    LoadedScene material(const char* json) {
        GltfWriter writer;
        const size_t mesh = writer.triangle();
        writer.json["materials"] = Json::array({Json::parse(json)});
        writer.json["meshes"][mesh]["primitives"][0]["material"] = 0;
        return load(writer);
    }
};

TEST_F(GltfMaterial, TakesMoreThanAllLightForAllOfIt) {
    const LoadedScene loaded = material(
        R"({"pbrMetallicRoughness": {"baseColorFactor": [2, 0.5, 1, 1]}, "emissiveFactor": [1, 0, 0],
            "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 1e30}}})");
    EXPECT_EQ(loaded.scene.materials[0].diffuse, glm::vec3(1, 0.5f, 1));
    EXPECT_EQ(loaded.scene.materials[0].emission, glm::vec3(kMostRadiance, 0, 0));
    ASSERT_EQ(loaded.warnings.size(), 2u);
    EXPECT_NE(loaded.warnings[0].text.find("has a baseColorFactor of 2, taken for 1"),
              std::string::npos)
        << loaded.warnings[0].text;
    EXPECT_NE(loaded.warnings[1].text.find("materials[0] has a radiance of 1e+30, taken for 7.92"),
              std::string::npos)
        << loaded.warnings[1].text;
}

/// More than opaque is opaque, also of what a texture multiplies.
TEST_F(GltfMaterial, TakesAnAlphaAboveOneForOne) {
    const LoadedScene loaded = material(R"({"alphaMode": "MASK",
        "pbrMetallicRoughness": {"baseColorFactor": [1, 1, 1, 1.5]}})");
    EXPECT_EQ(loaded.scene.materials[0].opacity, 1.0f);
    ASSERT_EQ(loaded.warnings.size(), 1u);
    EXPECT_NE(loaded.warnings[0].text.find("has a baseColorFactor of 1.5, taken for 1"),
              std::string::npos)
        << loaded.warnings[0].text;
    EXPECT_NE(errorOf([](auto& w) {
                  w = mapped();
                  w.json["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"] = {1, 1, 1, -1};
              }).find("has a negative baseColorFactor"),
              std::string::npos);
}

TEST_F(GltfMaterial, SamplersRepeatMirrorAndClamp) {
    GltfWriter writer = mapped();
    writer.json["textures"][0]["sampler"] = 0;
    const auto at = [&](const Json& sampler, float u) {
        writer.json["samplers"] = Json::array({sampler});
        return diffuse(writer, {u, 0.5f});
    };
    const Json repeat = Json::object(), mirror = {{"wrapS", 33648}}, clamp = {{"wrapS", 33071}};
    for (const float u : {1.1f, 1.25f, 1.4f}) {
        EXPECT_EQ(at(repeat, u), kRed) << u;
        EXPECT_EQ(at(mirror, u), kBlue) << u;
        EXPECT_EQ(at(clamp, u), kBlue) << u;
    }
    EXPECT_EQ(at(mirror, 1.75f), kRed);
    EXPECT_EQ(at(clamp, 1.9f), kBlue);
    EXPECT_EQ(at(clamp, -5.0f), kRed);
    writer.json["samplers"] = Json::array({{{"wrapS", 1}, {"magFilter", 9728}}});
    EXPECT_EQ(load(writer).ignored, (std::vector<std::string>{"glTF sampler magFilter NEAREST (1)",
                                                              "glTF sampler wrapS 1 (1)"}));
}

/// Where the texel is that coordinates of the file show: (u, v), v downwards, in the image.
TEST_F(GltfMaterial, TransformsTextureCoordinates) {
    const auto shown = [this](const Json& transform, glm::vec2 uv) {
        GltfWriter writer = mapped();
        writer.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["extensions"]
                   ["KHR_texture_transform"] = transform;
        const Scene scene = load(writer).scene;
        const Texture& texture = scene.textures.at(scene.materials.at(0).diffuseMap);
        const glm::vec2 at = texture.sampling().imageCoordinates({uv.x, 1.0f - uv.y});
        return glm::vec2(at.x, 1.0f - at.y);
    };
    const auto near = [](glm::vec2 a, glm::vec2 b) { return glm::length(a - b) < 0x1p-20f; };
    EXPECT_TRUE(near(shown(Json::object(), {0.25f, 0.75f}), {0.25f, 0.75f}));
    EXPECT_TRUE(near(shown({{"offset", {0.5, 0.125}}}, {0.25f, 0.5f}), {0.75f, 0.625f}));
    EXPECT_TRUE(near(shown({{"scale", {2, 3}}}, {0.25f, 0.5f}), {0.5f, 1.5f}));
    // Counterclockwise as seen: from the right to the top, where v is less.
    const double quarter = std::numbers::pi / 2;
    EXPECT_TRUE(near(shown({{"rotation", quarter}}, {1, 0}), {0, -1}));
    EXPECT_TRUE(near(shown({{"rotation", quarter}}, {0, 1}), {1, 0}));
    // Scaled, then turned, then moved.
    EXPECT_TRUE(
        near(shown({{"offset", {0.25, 0.5}}, {"scale", {2, 4}}, {"rotation", quarter}}, {1, 0.5f}),
             {2.25f, -1.5f}));
    EXPECT_EQ(errorOf([](auto& w) {
                  w = mapped();
                  w.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["extensions"]
                        ["KHR_texture_transform"] = {{"scale", {2}}};
              }),
              ": materials[0].pbrMetallicRoughness.baseColorTexture.extensions."
              "KHR_texture_transform.scale is not a list of 2 finite numbers");
}

TEST_F(GltfMaterial, OneSetOfTextureCoordinatesCounts) {
    GltfWriter writer = mapped({{"index", 0}, {"texCoord", 1}});
    Json& attributes = writer.json["meshes"][0]["primitives"][0]["attributes"];
    attributes["TEXCOORD_1"] = writer.vec2({0.5, 0, 1, 0, 0, 1});
    EXPECT_EQ(load(writer).scene.mesh.texcoords[0], glm::vec2(0.5f, 1.0f));
    // The transform's goes before that of the texture.
    writer.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["extensions"]
               ["KHR_texture_transform"]["texCoord"] = 0;
    EXPECT_EQ(load(writer).scene.mesh.texcoords[0], glm::vec2(0.0f, 1.0f));
    writer.json["materials"][0]["emissiveTexture"] = {{"index", 0}, {"texCoord", 1}};
    EXPECT_EQ(
        load(writer).ignored,
        std::vector<std::string>{"glTF texture texCoord that is not the material's first (1)"});
}

TEST_F(GltfMaterial, NormalMapsHaveAScale) {
    GltfWriter writer = mapped();
    writer.json["materials"][0]["normalTexture"] = {{"index", 0}, {"scale", 0.5}};
    const LoadedScene loaded = load(writer);
    const Material& material = loaded.scene.materials.at(0);
    ASSERT_NE(material.normalMap, kNoTexture);
    EXPECT_EQ(loaded.scene.textures.at(material.normalMap).encoding(), TexelEncoding::linear);
    EXPECT_EQ(material.normalScale, 0.5f);
    EXPECT_TRUE(loaded.ignored.empty());
}

TEST_F(GltfMaterial, VerticesHaveColours) {
    const auto colours = [this](const char* type, int components, auto values, bool normalized) {
        GltfWriter writer;
        const size_t mesh = writer.triangle();
        const int kind = sizeof(values[0]) == 4 ? 5126 : sizeof(values[0]) == 2 ? 5123 : 5121;
        const size_t accessor = writer.accessor(type, kind, (size_t) components, values);
        writer.json["accessors"][accessor]["normalized"] = normalized;
        writer.json["meshes"][mesh]["primitives"][0]["attributes"]["COLOR_0"] = accessor;
        writer.node({{"mesh", writer.mesh({{"attributes", {{"POSITION", 0}}}})}});
        return load(writer);
    };
    using Colours = std::vector<glm::vec3>;
    const glm::vec3 white(1.0f);
    // The second mesh has none, and is white.
    EXPECT_EQ(colours("VEC3", 3, std::vector<float>{1, 0, 0, 0, 0.5f, 0, 0, 0, 2}, false)
                  .scene.mesh.colors,
              (Colours{{1, 0, 0}, {0, 0.5f, 0}, {0, 0, 1}, white, white, white}));
    const LoadedScene bytes =
        colours("VEC4", 4, std::vector<uint8_t>{255, 0, 0, 255, 0, 51, 0, 255, 0, 0, 0, 128}, true);
    EXPECT_EQ(bytes.scene.mesh.colors,
              (Colours{{1, 0, 0}, {0, 0.2f, 0}, {0, 0, 0}, white, white, white}));
    EXPECT_EQ(bytes.ignored, std::vector<std::string>{"glTF attribute COLOR_0 alpha (1)"});
    EXPECT_EQ(colours("VEC3", 3, std::vector<uint16_t>{65535, 0, 0, 0, 13107, 0, 0, 0, 0}, true)
                  .scene.mesh.colors[1],
              glm::vec3(0, 0.2f, 0));
}

TEST_F(GltfMaterial, DielectricsReflectByTheirIndexAndSpecularFactor) {
    const auto reflectance = [this](const char* metal, const char* extensions) {
        return material((R"({"pbrMetallicRoughness": {"metallicFactor": )" + std::string(metal) +
                         R"(}, "extensions": {)" + extensions + "}}")
                            .c_str())
            .scene.materials.at(0)
            .reflectance;
    };
    EXPECT_EQ(reflectance("0", ""), 0.04f);
    EXPECT_EQ(reflectance("0", R"("KHR_materials_ior": {"ior": 1.5})"), 0.04f);
    EXPECT_EQ(reflectance("0", R"("KHR_materials_ior": {"ior": 3})"), 0.25f);
    EXPECT_EQ(reflectance("0", R"("KHR_materials_ior": {"ior": 0})"), 1.0f);
    EXPECT_EQ(reflectance("0", R"("KHR_materials_specular": {"specularFactor": 0.5})"), 0.02f);
    EXPECT_EQ(reflectance("0", R"("KHR_materials_ior": {"ior": 3}, "KHR_materials_specular":
        {"specularFactor": 0.5, "specularColorFactor": [2, 2, 2]})"),
              0.25f);
    EXPECT_EQ(reflectance("1", R"("KHR_materials_specular": {"specularFactor": 0})"), 1.0f);
    EXPECT_EQ(
        material(R"({"extensions": {"KHR_materials_specular":
        {"specularColorFactor": [1, 0, 0], "specularColorTexture": {"index": 0}}}})")
            .ignored,
        (std::vector<std::string>{"glTF material specular specularColorFactor but its mean (1)",
                                  "glTF material specular specularColorTexture (1)"}));
}

TEST_F(GltfMaterial, UnlitSurfacesEmitTheirColour) {
    GltfWriter writer = mapped();
    Json& json = writer.json["materials"][0];
    json["pbrMetallicRoughness"]["baseColorFactor"] = {0.5, 1, 0.25, 1};
    json["emissiveFactor"] = {7, 7, 7};
    json["extensions"]["KHR_materials_unlit"] = Json::object();
    const LoadedScene loaded = load(writer);
    const Material& material = loaded.scene.materials.at(0);
    EXPECT_EQ(material.diffuse, glm::vec3(0));
    EXPECT_EQ(material.reflectance, 0.0f);
    EXPECT_EQ(material.emission, glm::vec3(0.5f, 1, 0.25f));
    EXPECT_EQ(material.diffuseMap, kNoTexture);
    EXPECT_EQ(loaded.scene.textures.at(material.emissionMap).sample({0.25f, 0.5f}), kRed);
    EXPECT_EQ(loaded.ignored,
              std::vector<std::string>{
                  "glTF material extension KHR_materials_unlit but as emission (1)"});
}

TEST_F(GltfMaterial, WhatIsToBeBlendedIsCutOutAtAHalf) {
    const LoadedScene glass = material(R"({"alphaMode": "BLEND",
        "pbrMetallicRoughness": {"baseColorFactor": [1, 1, 1, 0.25]}})");
    EXPECT_EQ(glass.scene.materials.at(0).opacity, 0.25f);
    EXPECT_EQ(glass.ignored, std::vector<std::string>{
                                 "glTF material alphaMode BLEND but as a cut-out at 1/2 (1)"});
    ASSERT_EQ(glass.warnings.size(), 1u);
    EXPECT_EQ(glass.warnings[0].kind, WarningKind::unseenMaterial);
    EXPECT_NE(glass.warnings[0].text.find("materials[0] has an alpha below its cutoff"),
              std::string::npos);
    const LoadedScene seen = material(R"({"alphaMode": "BLEND",
        "pbrMetallicRoughness": {"baseColorFactor": [1, 1, 1, 0.75]}})");
    EXPECT_TRUE(seen.warnings.empty());
}

} // namespace
} // namespace dirt
