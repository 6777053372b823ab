// What glTF files that our own small writer makes are read as.

#include "tests/io/gltf_fixture.h"

namespace dirt {
namespace {

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
    EXPECT_TRUE(loaded.ignored.empty());
    ASSERT_EQ(loaded.warnings.size(), 1u);
    EXPECT_EQ(loaded.warnings[0].text,
              (folder_ / "a.gltf") + ": meshes[0].primitives[0] has normal 3, which is not finite: "
                                     "triangles with it have their own");
}

/// One warning of a kind; what no triangle uses may be anything.
TEST_F(Gltf, DoesWithoutAttributesThatAreNone) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    GltfWriter writer;
    const size_t positions = writer.vec3({0, 0, 0, 1, 0, 0, 0, 1, 0, nan, 0, 0});
    const size_t normals = writer.vec3({0, 0, 0, 0, 0, 0, 0, 0, 1, nan, 0, 0});
    const size_t uvs = writer.accessor<float>("VEC2", 5126, 2, {0, nan, 0, 0, nan, 0, nan, nan});
    writer.node(
        {{"mesh",
          writer.mesh(
              {{"attributes", {{"POSITION", positions}, {"NORMAL", normals}, {"TEXCOORD_0", uvs}}},
               {"indices", writer.indices<uint16_t>({0, 1, 2})}})}});
    const LoadedScene loaded = load(writer);
    const Corners none{kNoIndex, kNoIndex, kNoIndex};
    EXPECT_EQ(loaded.scene.mesh.normalIndices, std::vector<Corners>{none});
    EXPECT_EQ(loaded.scene.mesh.texcoordIndices, std::vector<Corners>{none});
    EXPECT_EQ(loaded.scene.mesh.positions.size(), 3u);
    const std::string place = (folder_ / "a.gltf") + ": meshes[0].primitives[0] has ";
    std::vector<std::string> texts;
    for (const Warning& warning : loaded.warnings) texts.push_back(warning.text);
    EXPECT_EQ(
        texts,
        (std::vector<std::string>{
            place + "normal 0, which has no length: triangles with it have their own (2 times)",
            place + "texture coordinates 0, which are not finite: triangles with them have "
                    "none (2 times)",
            place + "position 3, which is not finite: no triangle uses it"}));
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
    EXPECT_EQ(
        error("a.gltf", writer.embedded()),
        ": accessors[1] has no data and 4000000000 elements, which is absurd in a file of 1320 "
        "bytes (4000000000 with those before)");
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
    twoColours("rough.png", {0, 51, 255, 255}, {0, 153, 0, 255});
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
    EXPECT_EQ(loaded.metallic, 1.0f);
    EXPECT_EQ(loaded.roughness, 0.5f * 0.5f);
    EXPECT_EQ(loaded.reflectance, 0.04f); // of what is no metal
    const ScalarTexture& roughness = scene.scalarTextures.at(loaded.roughnessMap);
    EXPECT_EQ(roughness.sample({0.25f, 0.5f}), 51.0f / 255.0f);
    EXPECT_EQ(roughness.sample({0.75f, 0.5f}), 153.0f / 255.0f);
    EXPECT_EQ(scene.scalarTextures.at(loaded.metallicMap).sample({0.25f, 0.5f}), 1.0f);
    EXPECT_EQ(scene.scalarTextures.at(loaded.metallicMap).sample({0.75f, 0.5f}), 0.0f);
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
        return loaded.scene.textures.at(0).sample({0.5f, 0.5f}) *
               loaded.scene.materials.at(0).diffuseMapFactor;
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
    EXPECT_EQ(
        warning({{"uri", "data:image/png;base64,AAAA"}}),
        folder_ / "a.gltf: texture 'images[0]': " + (folder_ / "a.gltf/images[0]") +
            ": is none of the images that are read: PNG, JPEG, OpenEXR, Radiance HDR, TIFF, BMP, "
            "TGA, WebP, DDS, PNM and PFM");
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

/// What a file says of sides counts where the scene does not want two of everything.
TEST_F(Gltf, SurfacesHaveTwoSidesUnlessTheSceneSaysOtherwise) {
    for (const bool inFile : {false, true}) {
        GltfWriter writer;
        const size_t mesh = writer.triangle();
        writer.json["materials"] = Json::parse("[{}]");
        writer.json["materials"][0]["doubleSided"] = inFile;
        writer.json["meshes"][mesh]["primitives"][0]["material"] = 0;
        folder_.write("a.glb", writer.binary());
        const auto twoSided = [&](const std::string& attributes) {
            const LoadedScene loaded = loadScene(folder_.write(
                "a.scene", "<world><object file='a.glb' " + attributes + "/></world>"));
            return loaded.scene.materials.at(0).doubleSided;
        };
        EXPECT_TRUE(load(writer).scene.materials.at(0).doubleSided);
        EXPECT_TRUE(twoSided(""));
        EXPECT_TRUE(twoSided("double_sided='true'"));
        EXPECT_EQ(twoSided("double_sided='false'"), inFile);
    }
}

TEST_F(Gltf, MirrorsKeepTheirFronts) {
    GltfWriter writer;
    writer.triangle();
    folder_.write("a.glb", writer.binary());
    const auto front = [&](const std::string& scale) {
        const LoadedScene loaded = loadScene(
            folder_.write("a.scene", "<world><transformation scale='" + scale +
                                         "'><object file='a.glb'/></transformation></world>"));
        const auto& p = loaded.scene.mesh.positions;
        const Corners& c = loaded.scene.mesh.triangles.at(0);
        return glm::cross(p[c[1]] - p[c[0]], p[c[2]] - p[c[0]]);
    };
    const glm::vec3 n = front("1 1 1");
    EXPECT_NE(n, glm::vec3(0.0f));
    EXPECT_EQ(front("-1 1 1") * n, n * n * glm::vec3(-1, 1, 1));
    EXPECT_EQ(front("1 1 -1") * n, n * n * glm::vec3(1, 1, -1));
    EXPECT_EQ(front("-1 -1 1") * n, n * n * glm::vec3(-1, -1, 1));
}

} // namespace
} // namespace dirt
