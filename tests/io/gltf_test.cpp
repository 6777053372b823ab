// glTF files that our own small writer makes, sound and damaged ones.

#include "core/io/gltf.h"
#include "core/io/load.h"
#include "tests/io/gltf_writer.h"
#include "tests/io/input_error.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include <OpenImageIO/imageio.h>
#include <glm/geometric.hpp>

namespace dirt {
namespace {

using test::GltfWriter;
using test::Json;

class Gltf : public testing::Test {
protected:
    LoadedScene load(const GltfWriter& writer) {
        return loadScene(folder_.write("a.gltf", writer.embedded()));
    }
    /// The error's text after the file's name.
    std::string error(const std::string& name, const std::string& content) {
        const std::string file = folder_.write(name, content);
        const std::string what = inputError([&] { loadScene(file); });
        EXPECT_EQ(what.find_first_of("\r\n"), what.npos) << what;
        return what.rfind(file, 0) == 0 ? what.substr(file.size()) : what;
    }
    /// Of a file with one triangle that \p damage spoils.
    std::string errorOf(const std::function<void(GltfWriter&)>& damage) {
        GltfWriter writer;
        writer.triangle();
        damage(writer);
        return error("a.gltf", writer.embedded());
    }
    /// The bytes of a PNG or JPEG file of one colour.
    std::string image(const std::string& name, unsigned char r, unsigned char g, unsigned char b) {
        const std::string path = folder_ / name;
        const OIIO::ImageSpec spec(8, 8, 3, OIIO::TypeDesc::UINT8);
        std::vector<unsigned char> texels;
        for (int i = 0; i < 64; ++i) texels.insert(texels.end(), {r, g, b});
        const auto output = OIIO::ImageOutput::create(path);
        EXPECT_TRUE(output && output->open(path, spec) &&
                    output->write_image(OIIO::TypeDesc::UINT8, texels.data()) && output->close());
        return test::readFile(path);
    }
    /// A PNG file of 8x8 texels, the left half of the one colour, the right of the other.
    void twoColours(const std::string& name, std::array<unsigned char, 4> left,
                    std::array<unsigned char, 4> right) {
        const std::string path = folder_ / name;
        const OIIO::ImageSpec spec(8, 8, 4, OIIO::TypeDesc::UINT8);
        std::vector<unsigned char> texels;
        for (int i = 0; i < 64; ++i) {
            const auto& colour = i % 8 < 4 ? left : right;
            texels.insert(texels.end(), colour.begin(), colour.end());
        }
        const auto output = OIIO::ImageOutput::create(path);
        EXPECT_TRUE(output && output->open(path, spec) &&
                    output->write_image(OIIO::TypeDesc::UINT8, texels.data()) && output->close());
    }
    /// A triangle whose material has \p image as its base colour.
    static GltfWriter textured(const Json& image) {
        GltfWriter writer;
        writer.triangle();
        writer.json["images"] = Json::array({image});
        writer.json["textures"] = Json::array({{{"source", 0}}});
        writer.json["materials"] =
            Json::array({{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}});
        writer.json["meshes"][0]["primitives"][0]["material"] = 0;
        return writer;
    }

    test::TemporaryFolder folder_;
};

TEST_F(Gltf, TheThreeContainersHoldTheSame) {
    GltfWriter writer;
    writer.triangle();
    folder_.write("my data.bin", writer.bytes);
    for (const std::string& file : {folder_.write("a.gltf", writer.embedded()),
                                    folder_.write("b.GLTF", writer.external("My%20Data.bin")),
                                    folder_.write("c.glb", writer.binary())}) {
        const LoadedScene loaded = loadScene(file);
        const Mesh& mesh = loaded.scene.mesh;
        EXPECT_EQ(mesh.positions, (std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}))
            << file;
        EXPECT_EQ(mesh.triangles, (std::vector<Corners>{{0, 1, 2}}));
        EXPECT_TRUE(loaded.warnings.empty());
        EXPECT_TRUE(loaded.ignored.empty()) << loaded.ignored.front();
        EXPECT_FALSE(loaded.hasCamera);
        EXPECT_EQ(loaded.scene.materials.size(), 1u) << "the default";
    }
}

TEST_F(Gltf, ReadsStripsFansAndEveryKindOfIndex) {
    GltfWriter writer;
    const size_t positions = writer.vec3({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 2, 2, 0});
    const Json attributes = {{"POSITION", positions}};
    writer.node({{"mesh", writer.mesh({{"attributes", attributes},
                                       {"mode", 5},
                                       {"indices", writer.indices<uint8_t>({0, 1, 2, 3, 4})}})}});
    writer.node({{"mesh", writer.mesh({{"attributes", attributes},
                                       {"mode", 6},
                                       {"indices", writer.indices<uint16_t>({0, 1, 3, 2})}})}});
    writer.node({{"mesh", writer.mesh({{"attributes", attributes},
                                       {"indices", writer.indices<uint32_t>({4, 3, 1})}})}});
    writer.node({{"mesh", writer.mesh({{"attributes", attributes}, {"mode", 1}})}}); // lines
    const Mesh mesh = load(writer).scene.mesh;
    std::vector<std::array<glm::vec3, 3>> triangles;
    for (const Corners& c : mesh.triangles)
        triangles.push_back({mesh.positions[c[0]], mesh.positions[c[1]], mesh.positions[c[2]]});
    const glm::vec3 p[] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 2, 0}};
    EXPECT_EQ(triangles,
              (std::vector<std::array<glm::vec3, 3>>{{p[0], p[1], p[2]},
                                                     {p[1], p[3], p[2]}, // the winding is kept
                                                     {p[2], p[3], p[4]},
                                                     {p[1], p[3], p[0]},
                                                     {p[3], p[2], p[0]},
                                                     {p[4], p[3], p[1]}}));
}

TEST_F(Gltf, NodesPlaceMeshes) {
    GltfWriter writer;
    const size_t mesh = writer.triangle(); // at the root, as it is
    // A quarter turn about Y, which takes +Z to +X, after a scale and before a move.
    const double half = std::sqrt(0.5);
    const size_t parent = writer.node(
        {{"translation", {10, 0, 0}}, {"rotation", {0, half, 0, half}}, {"scale", {1, 2, 1}}});
    writer.json["nodes"].push_back(
        {{"mesh", mesh}, {"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 5, 1}}});
    writer.json["nodes"][parent]["children"] = {2};
    const Mesh loaded = load(writer).scene.mesh;
    ASSERT_EQ(loaded.positions.size(), 6u);
    const glm::vec3 expected[] = {{15, 0, 0}, {15, 0, -1}, {15, 2, 0}};
    for (int i = 0; i < 3; ++i)
        // The quaternion's entries are right to an ulp of double: far below one of float32 at 15.
        EXPECT_LE(glm::length(loaded.positions[(size_t) i + 3] - expected[i]), 0x1p-20f) << i;
    // Without scenes, every node that is no one's child is a root.
    writer.json.erase("scenes");
    EXPECT_EQ(load(writer).scene.mesh.positions, loaded.positions);
    // Of several scenes, `scene` counts.
    writer.json["scenes"] = Json::parse(R"([{"nodes":[0]},{"nodes":[1]}])");
    writer.json["scene"] = 1;
    EXPECT_EQ(load(writer).scene.mesh.triangles.size(), 1u);
}

TEST_F(Gltf, ReadsNormalsAndTextureCoordinates) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    GltfWriter writer;
    const size_t positions = writer.vec3({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1});
    const size_t normals = writer.vec3({0, 0, 2, 0, 0, 1, 0, 0, 1, nan, 0, 0});
    const size_t bytes = writer.accessor<uint8_t>("VEC2", 5121, 2, {0, 0, 255, 0, 51, 255, 0, 0});
    writer.json["accessors"][bytes]["normalized"] = true;
    const size_t indices = writer.indices<uint16_t>({0, 1, 2, 0, 1, 3});
    writer.node({{"mesh", writer.mesh({{"attributes",
                                        {{"POSITION", positions},
                                         {"NORMAL", normals},
                                         {"TEXCOORD_0", bytes},
                                         {"COLOR_0", positions}}},
                                       {"indices", indices}})}});
    const LoadedScene loaded = load(writer);
    const Mesh& mesh = loaded.scene.mesh;
    EXPECT_EQ(mesh.normalIndices,
              (std::vector<Corners>{{0, 1, 2}, {kNoIndex, kNoIndex, kNoIndex}}));
    EXPECT_EQ(mesh.normals[0], glm::vec3(0, 0, 1));
    EXPECT_EQ(mesh.texcoordIndices, (std::vector<Corners>{{0, 1, 2}, {0, 1, 3}}));
    EXPECT_EQ(mesh.texcoords[0], glm::vec2(0, 1)); // v upwards here, downwards there
    EXPECT_EQ(mesh.texcoords[2], glm::vec2(0.2f, 0));
    EXPECT_EQ(loaded.ignored, std::vector<std::string>{"glTF attribute COLOR_0"});
}

TEST_F(Gltf, ReadsStridesAndSparseAccessors) {
    GltfWriter writer;
    // Positions with a gap of 4 bytes after each, the second of them replaced.
    const std::vector<float> data = {0, 0, 0, 9, 7, 7, 7, 9, 0, 1, 0};
    const size_t view = writer.view({(const char*) data.data(), data.size() * 4});
    writer.json["bufferViews"][view]["byteStride"] = 16;
    const uint8_t place = 1;
    const float value[] = {1, 0, 0};
    const size_t places = writer.view({(const char*) &place, 1});
    const size_t values = writer.view({(const char*) value, 12});
    const Json sparse = {{"count", 1},
                         {"indices", {{"bufferView", places}, {"componentType", 5121}}},
                         {"values", {{"bufferView", values}}}};
    writer.json["accessors"] = Json::array(
        {{{"bufferView", view},
          {"componentType", 5126},
          {"count", 3},
          {"type", "VEC3"},
          {"sparse", sparse}},
         {{"componentType", 5126}, {"count", 3}, {"type", "VEC3"}, {"sparse", sparse}}});
    writer.node({{"mesh", writer.mesh({{"attributes", {{"POSITION", 0}}}})}});
    writer.node({{"mesh", writer.mesh({{"attributes", {{"POSITION", 1}}}})}});
    EXPECT_EQ(
        load(writer).scene.mesh.positions,
        (std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {1, 0, 0}, {0, 0, 0}}));
    writer.json["accessors"][1]["sparse"]["count"] = 2;
    EXPECT_EQ(error("a.gltf", writer.embedded()),
              ": accessors[1].sparse.indices reaches beyond its bufferView");
    writer.json["accessors"][1]["sparse"]["count"] = 4;
    EXPECT_EQ(error("a.gltf", writer.embedded()),
              ": accessors[1].sparse.count is not a whole number from 0 to 3");
    writer.json["accessors"][1]["sparse"]["count"] = 1;
    writer.json["accessors"][1]["count"] = 1;
    EXPECT_EQ(error("a.gltf", writer.embedded()),
              ": accessors[1].sparse.indices holds 1, of 1 elements");
    writer.json["accessors"][1]["count"] = 4'000'000'000;
    EXPECT_EQ(error("a.gltf", writer.embedded()),
              ": accessors[1] has no data and 4000000000 elements, which is absurd");
}

TEST_F(Gltf, ReadsMaterials) {
    GltfWriter writer;
    const size_t mesh = writer.triangle();
    writer.json["materials"] = Json::parse(R"([
        {"name": "unused"},
        {"name": "lamp", "emissiveFactor": [1, 0.5, 0],
         "pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.25, 1, 1]},
         "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 8}}}])");
    writer.json["extensionsRequired"] = {"KHR_materials_emissive_strength"};
    writer.json["meshes"][mesh]["primitives"][0]["material"] = 1;
    const Scene scene = load(writer).scene;
    ASSERT_EQ(scene.materials.size(), 1u);
    EXPECT_EQ(scene.materials[0].name, "lamp");
    EXPECT_EQ(scene.materials[0].diffuse, glm::vec3(0.5f, 0.25f, 1.0f));
    EXPECT_EQ(scene.materials[0].emission, glm::vec3(8, 4, 0));
}

TEST_F(Gltf, MapsMetallicRoughness) {
    GltfWriter writer;
    const size_t mesh = writer.triangle();
    const auto material = [&](const char* json) {
        writer.json["materials"] = Json::array({Json::parse(json)});
        writer.json["meshes"][mesh]["primitives"][0]["material"] = 0;
        return load(writer).scene.materials.at(0);
    };
    const Material bare = material("{}");
    EXPECT_EQ(bare.diffuse, glm::vec3(1.0f));
    EXPECT_EQ(bare.metallic, 1.0f); // by glTF's defaults
    EXPECT_EQ(bare.roughness, 1.0f);
    EXPECT_EQ(bare.reflectance, 1.0f);
    EXPECT_EQ(bare.opacity, 1.0f);
    const Material plastic =
        material(R"({"pbrMetallicRoughness": {"metallicFactor": 0, "roughnessFactor": 0.5}})");
    EXPECT_EQ(plastic.metallic, 0.0f);
    EXPECT_EQ(plastic.roughness, 0.25f);
    EXPECT_EQ(plastic.reflectance, 0.04f);
    // Cut out where alpha is below the cutoff: where opacity is below a half.
    EXPECT_EQ(material(R"({"alphaMode": "MASK", "alphaCutoff": 0.25,
        "pbrMetallicRoughness": {"baseColorFactor": [1, 1, 1, 0.125]}})")
                  .opacity,
              0.25f);
    EXPECT_EQ(material(R"({"alphaMode": "OPAQUE",
        "pbrMetallicRoughness": {"baseColorFactor": [1, 1, 1, 0.125]}})")
                  .opacity,
              1.0f);
    EXPECT_EQ(material(R"({"alphaMode": "MASK", "alphaCutoff": 0,
        "pbrMetallicRoughness": {"baseColorFactor": [1, 1, 1, 0]}})")
                  .opacity,
              1.0f);
}

TEST_F(Gltf, MapsTextures) {
    // Alpha 0.8 and 0.4: beside a cutoff of 0.6 one half is there.
    twoColours("mask.png", {255, 0, 0, 204}, {255, 0, 0, 102});
    twoColours("glow.png", {255, 255, 255, 255}, {0, 0, 0, 255});
    twoColours("rough.png", {0, 51, 255, 255}, {0, 153, 0, 255}); // means 0.4 and 0.5
    GltfWriter writer = textured({{"uri", "mask.png"}});
    writer.json["images"].push_back({{"uri", "glow.png"}});
    writer.json["images"].push_back({{"uri", "rough.png"}});
    writer.json["textures"] = Json::parse(R"([{"source":0},{"source":1},{"source":2}])");
    Json& material = writer.json["materials"][0];
    material["alphaMode"] = "MASK";
    material["alphaCutoff"] = 0.6;
    material["emissiveFactor"] = {0, 2, 0};
    material["emissiveTexture"] = {{"index", 1}};
    material["pbrMetallicRoughness"]["metallicRoughnessTexture"] = {{"index", 2}};
    material["pbrMetallicRoughness"]["roughnessFactor"] = 0.5;
    const Scene scene = load(writer).scene;
    const Material& loaded = scene.materials.at(0);
    ASSERT_NE(loaded.opacityMap, kNoTexture);
    const ScalarTexture& alpha = scene.scalarTextures.at(loaded.opacityMap);
    EXPECT_GE(loaded.opacity * alpha.sample({0.25f, 0.5f}), 0.5f);
    EXPECT_LT(loaded.opacity * alpha.sample({0.75f, 0.5f}), 0.5f);
    EXPECT_EQ(loaded.emission, glm::vec3(0, 2, 0));
    EXPECT_EQ(scene.textures.at(loaded.emissionMap).sample({0.25f, 0.5f}), glm::vec3(1));
    EXPECT_EQ(scene.textures.at(loaded.emissionMap).sample({0.75f, 0.5f}), glm::vec3(0));
    EXPECT_NEAR(loaded.metallic, 0.5f, 0x1p-24f); // sums in double, rounded once or twice
    EXPECT_NEAR(loaded.roughness, 0.2f * 0.2f, 4 * 0x1p-29f);
    // A glow that cannot be read does not make all of the surface shine.
    std::filesystem::remove(folder_ / "glow.png");
    const LoadedScene dark = load(writer);
    EXPECT_EQ(dark.warnings.size(), 1u);
    EXPECT_EQ(dark.scene.materials.at(0).emission, glm::vec3(0));
}

TEST_F(Gltf, ReadsImagesFromWhereverTheyAre) {
    const std::string png = image("Red Wall.png", 255, 0, 0), jpeg = image("wall.jpg", 0, 0, 255);
    const auto colourOf = [this](const GltfWriter& writer) {
        const LoadedScene loaded = load(writer);
        for (const Warning& warning : loaded.warnings) ADD_FAILURE() << warning.text;
        EXPECT_EQ(loaded.scene.textures.size(), 1u);
        EXPECT_EQ(loaded.scene.materials.at(0).diffuseMap, 0u);
        return loaded.scene.textures.at(0).sample({0.5f, 0.5f});
    };
    EXPECT_EQ(colourOf(textured({{"uri", "red%20wall.PNG"}})), glm::vec3(1, 0, 0));
    EXPECT_EQ(colourOf(textured({{"uri", "data:image/png;base64," + GltfWriter::base64(png)}})),
              glm::vec3(1, 0, 0));
    GltfWriter writer = textured({{"bufferView", 0}, {"mimeType", "image/jpeg"}});
    writer.json["images"][0]["bufferView"] = writer.view(jpeg);
    EXPECT_GT(colourOf(writer).z, 0.9f);
    EXPECT_LT(colourOf(writer).x, 0.01f);
    // The base colour multiplies its texture.
    writer = textured({{"uri", "Red Wall.png"}});
    writer.json["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"] = {0.25, 1, 1, 1};
    EXPECT_EQ(colourOf(writer), glm::vec3(0.25f, 0, 0));
}

TEST_F(Gltf, UnusableImagesAreWarnings) {
    folder_.write("damaged.png", "no image");
    const auto warning = [this](const Json& source) {
        const LoadedScene loaded = load(textured(source));
        EXPECT_EQ(loaded.warnings.size(), 1u);
        EXPECT_EQ(loaded.scene.materials.at(0).diffuseMap, kNoTexture);
        EXPECT_EQ(loaded.warnings.at(0).kind, WarningKind::unusableTexture);
        return loaded.warnings.at(0).text;
    };
    EXPECT_EQ(warning({{"uri", "none.png"}}), folder_ / "a.gltf: texture 'none.png' not found");
    EXPECT_EQ(
        warning({{"uri", "damaged.png"}}).rfind(folder_ / "a.gltf: texture 'damaged.png': ", 0),
        0u);
    EXPECT_EQ(warning({{"uri", "data:image/png;base64,AAAA"}}),
              folder_ / "a.gltf: texture 'images[0]': " + (folder_ / "a.gltf/images[0]") +
                  ": is neither PNG nor JPEG");
    const std::string file = folder_ / "a.gltf";
    EXPECT_NE(inputError([&] { loadScene(file, {.strict = true}); }), "");
}

TEST_F(Gltf, InASceneFile) {
    GltfWriter writer;
    writer.triangle();
    folder_.write("a.glb", writer.binary());
    const LoadedScene loaded = loadScene(folder_.write(
        "a.scene", "<world><transformation translation='0 0 2'><animation><key time='0' "
                   "scale='2 2 2'/></animation><object file='A.GLB'/></transformation></world>"));
    EXPECT_EQ(loaded.scene.mesh.positions[1], glm::vec3(2, 0, 2));
    EXPECT_EQ(loaded.scene.animation.parts.at(0).positions.at(1), glm::vec3(1, 0, 0));
}

TEST_F(Gltf, RefusesWhatReachesTooFar) {
    EXPECT_EQ(errorOf([](auto& w) { w.json["accessors"][0]["count"] = 4; }),
              ": accessors[0] reaches beyond its bufferView");
    EXPECT_EQ(errorOf([](auto& w) { w.json["accessors"][0]["byteOffset"] = 1; }),
              ": accessors[0] reaches beyond its bufferView");
    EXPECT_EQ(errorOf([](auto& w) { w.json["accessors"][0]["byteOffset"] = 1ull << 52; }),
              ": accessors[0] reaches beyond its bufferView");
    EXPECT_EQ(errorOf([](auto& w) { w.json["accessors"][0]["count"] = 0xffffffffu; }),
              ": accessors[0] reaches beyond its bufferView");
    EXPECT_EQ(errorOf([](auto& w) { w.json["bufferViews"][0]["byteStride"] = 16; }),
              ": accessors[0] reaches beyond its bufferView");
    EXPECT_EQ(errorOf([](auto& w) { w.json["bufferViews"][0]["byteStride"] = 8; }),
              ": accessors[0] has elements longer than their byteStride");
    EXPECT_EQ(errorOf([](auto& w) { w.json["bufferViews"][0]["byteLength"] = 37; }),
              ": bufferViews[0] reaches beyond its buffer");
    EXPECT_EQ(errorOf([](auto& w) { w.json["bufferViews"][0]["buffer"] = 1; }),
              ": bufferViews[0] refers to a buffer that is not there");
    EXPECT_EQ(errorOf([](auto& w) { w.json["accessors"][0]["bufferView"] = 1; }),
              ": accessors[0] refers to bufferViews[1], of which there are 1");
    EXPECT_EQ(errorOf([](auto& w) {
                  w.json["meshes"][0]["primitives"][0]["indices"] =
                      w.template indices<uint16_t>({0, 1, 3});
              }),
              ": meshes[0].primitives[0] has index 3, of 3 positions");
    EXPECT_EQ(
        errorOf([](auto& w) {
            w.json["meshes"][0]["primitives"][0]["indices"] = w.template indices<uint16_t>({0, 1});
        }),
        ": meshes[0].primitives[0] has 2 corners, which make no whole triangles");
    EXPECT_EQ(errorOf([](auto& w) { w.json["meshes"][0]["primitives"][0]["material"] = 0; }),
              ": meshes[0].primitives[0] refers to a material that is not there");
    EXPECT_EQ(errorOf([](auto& w) { w.json["nodes"][0]["mesh"] = 7; }),
              ": nodes[0] refers to a mesh that is not there");
    EXPECT_EQ(errorOf([](auto& w) { w.json["scene"] = 1; }),
              ": the root refers to scenes[1], of which there are 1");
}

TEST_F(Gltf, RefusesWrongKinds) {
    const auto attribute = [](const char* name, size_t accessor) {
        return [=](GltfWriter& w) {
            w.json["meshes"][0]["primitives"][0]["attributes"][name] = accessor;
        };
    };
    EXPECT_EQ(
        errorOf([&](auto& w) {
            attribute("POSITION", w.template accessor<int16_t>("VEC3", 5122, 3, {0, 0, 0}))(w);
        }),
        ": accessors[1] has a componentType that is not allowed here");
    EXPECT_EQ(errorOf([&](auto& w) {
                  attribute("NORMAL", w.vec2({0, 0, 1, 1, 2, 2}))(w);
              }),
              ": accessors[1] is not of the type VEC3");
    EXPECT_EQ(errorOf([&](auto& w) {
                  attribute("NORMAL", w.vec3({0, 0, 1}))(w);
              }),
              ": meshes[0].primitives[0].attributes have not all as many elements");
    EXPECT_EQ(errorOf([](auto& w) { w.json["accessors"][0]["componentType"] = 5124; }),
              ": accessors[0] has an unknown componentType");
    EXPECT_EQ(errorOf([](auto& w) { w.json["accessors"][0]["count"] = "3"; }),
              ": accessors[0].count is not a whole number from 0 to 4294967295");
    EXPECT_EQ(errorOf([](auto& w) { w.json["accessors"][0]["count"] = -3; }),
              ": accessors[0].count is not a whole number from 0 to 4294967295");
    EXPECT_EQ(errorOf([](auto& w) { w.json["accessors"][0]["count"] = 2.5; }),
              ": accessors[0].count is not a whole number from 0 to 4294967295");
    EXPECT_EQ(errorOf([](auto& w) { w.json["meshes"] = 3; }), ": meshes is not an array");
    EXPECT_EQ(errorOf([](auto& w) { w.json["meshes"][0] = "mesh"; }),
              ": meshes[0] is not an object");
    EXPECT_EQ(errorOf([](auto& w) { w.json["meshes"][0]["primitives"][0].erase("attributes"); }),
              ": meshes[0].primitives[0] has no attributes");
    EXPECT_EQ(errorOf([](auto& w) { w.json["meshes"][0]["primitives"][0]["mode"] = 7; }),
              ": meshes[0].primitives[0].mode is not a whole number from 0 to 6");
    EXPECT_EQ(errorOf([](auto& w) {
                  w.json["nodes"][0]["scale"] = {1, 2};
              }),
              ": nodes[0].scale is not a list of 3 finite numbers");
    EXPECT_EQ(errorOf([](auto& w) {
                  w.json["nodes"][0]["translation"] = {1, 2, 1e39};
              }),
              ": nodes[0].translation is not a list of 3 finite numbers");
    EXPECT_EQ(errorOf([](auto& w) {
                  w.json["nodes"][0]["rotation"] = {0, 0, 0, 0};
              }),
              ": nodes[0] has a rotation of no length");
    EXPECT_EQ(errorOf([](auto& w) {
                  w.json["nodes"][0]["matrix"] = {1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
              }),
              ": nodes[0] has a matrix that is not affine");
    EXPECT_EQ(errorOf([](auto& w) {
                  w.json["materials"] = Json::parse(R"([{"emissiveFactor": [1, -1, 0]}])");
              }),
              ": materials[0] has a negative emissiveFactor");
    EXPECT_EQ(errorOf([](auto& w) { w.json["extensionsRequired"] = {"KHR_draco"}; }),
              ": requires the extension 'KHR_draco', which is not known here");
    EXPECT_EQ(errorOf([](auto& w) { w.json["asset"]["version"] = "1.0"; }),
              ": is of glTF version '1.0'; 2.0 can be read");
}

TEST_F(Gltf, RefusesNumbersThatAreNone) {
    for (const float bad :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()})
        EXPECT_EQ(errorOf([&](auto& w) { std::memcpy(w.bytes.data() + 16, &bad, 4); }),
                  ": meshes[0].primitives[0] has position 1, which is not finite");
    EXPECT_EQ(errorOf([](auto& w) {
                  const float large = 1e38f;
                  std::memcpy(w.bytes.data() + 12, &large, 4);
                  w.json["nodes"][0]["scale"] = {9, 1, 1};
              }),
              ": a vertex does not fit in float32 after its transformation");
}

TEST_F(Gltf, RefusesNodesThatMakeNoTree) {
    EXPECT_EQ(errorOf([](auto& w) { w.json["nodes"][0]["children"] = {0}; }),
              ": nodes[0] is reached twice: nodes make a tree");
    EXPECT_EQ(errorOf([](auto& w) {
                  w.json["nodes"][0]["children"] = {1};
                  w.json["nodes"].push_back({{"children", {0}}});
              }),
              ": nodes[0] is reached twice: nodes make a tree");
    EXPECT_EQ(errorOf([](auto& w) { w.json["nodes"][0]["children"] = {5}; }),
              ": the root refers to nodes[5], of which there are 1");
    // Deep trees are no trouble.
    GltfWriter writer;
    writer.triangle();
    for (size_t i = 0; i < 20'000; ++i) writer.json["nodes"].push_back({{"children", {i + 2}}});
    writer.json["nodes"].push_back({{"mesh", 0}});
    writer.json["nodes"][0]["children"] = {1};
    EXPECT_EQ(load(writer).scene.mesh.triangles.size(), 2u);
    // Nor is deep JSON.
    const std::string deep(200'000, '[');
    EXPECT_EQ(error("deep.gltf", "{\"extras\":" + deep + std::string(deep.size(), ']') + "}"),
              ": the root has no asset");
}

TEST_F(Gltf, RefusesAbsurdlyManyTriangles) {
    GltfWriter writer;
    const size_t count = 1 << 18; // from nothing, which is allowed
    writer.json["accessors"] =
        Json::array({{{"componentType", 5126}, {"count", count / 3 * 3}, {"type", "VEC3"}}});
    writer.view("    ");
    const size_t mesh = writer.mesh({{"attributes", {{"POSITION", 0}}}});
    for (int i = 0; i < 4000; ++i) writer.node({{"mesh", mesh}});
    EXPECT_NE(error("a.gltf", writer.embedded()).find("which is absurd"), std::string::npos);
}

TEST_F(Gltf, RefusesDamagedContainers) {
    GltfWriter writer;
    writer.triangle();
    const std::string binary = writer.binary(), text = writer.embedded();
    for (size_t length = 0; length < binary.size(); ++length)
        ASSERT_NE(error("a.glb", binary.substr(0, length)), "") << length << " bytes";
    for (size_t length = 0; length + 1 < text.size(); ++length)
        ASSERT_NE(error("a.gltf", text.substr(0, length)), "") << length << " bytes";
    EXPECT_EQ(error("a.gltf", "{\n\"asset\": {\n\"version\" \"2.0\"}}"),
              ":3: is no well-formed JSON");
    EXPECT_EQ(error("a.gltf", "[]"), ": the root is not an object");
    EXPECT_EQ(error("a.gltf", writer.external("none.bin")),
              ": buffers[0] is in a file that is not there: 'none.bin'");
    folder_.write("short.bin", writer.bytes.substr(1));
    EXPECT_EQ(error("a.gltf", writer.external("short.bin")), ": buffers[0] has 35 bytes, not 36");
    EXPECT_EQ(error("a.gltf", writer.external("data:;base64,A*")),
              ": buffers[0] has a data URI with a character that is not of base64");
    EXPECT_EQ(error("a.gltf", writer.external("data:text/plain,abc")),
              ": buffers[0] has a data URI that is not in base64");
    std::string version = binary;
    version[4] = 1;
    EXPECT_EQ(error("a.glb", version), ": is binary glTF of version 1; 2 can be read");
    std::string chunk = binary; // longer than the file, by as little as can be
    chunk.replace(20 + binary.find("BIN") - 20 - 4, 4, GltfWriter::number(36 + 4));
    EXPECT_EQ(error("a.glb", chunk), ": has a chunk that is cut short");
    GltfWriter empty;
    EXPECT_EQ(error("a.gltf", empty.embedded()), ": holds no triangles");
}

} // namespace
} // namespace dirt
