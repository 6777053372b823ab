// What glTF files have that is without effect is named, at every level, with how often it is there.

#include "core/io/gltf_members.h"
#include "tests/io/gltf_fixture.h"

namespace dirt {
namespace {

TEST_F(Gltf, NamesWhatItDoesNotKnowAtEveryLevel) {
    GltfWriter writer = textured({{"uri", "data:image/png;base64,AAAA"}});
    Json& json = writer.json;
    writer.node({{"mesh", 0}, {"skin", 0}, {"weights", {1, 2}}});
    writer.node({{"mesh", 0}, {"skin", 0}});
    json["samplers"] = Json::array({Json::object()});
    json["cameras"] = Json::parse(R"([{"type": "orthographic", "orthographic": {"ymag": 1}}])");
    for (const char* place :
         {"", "/scenes/0", "/nodes/0", "/meshes/0", "/meshes/0/primitives/0", "/accessors/0",
          "/bufferViews/0", "/samplers/0", "/textures/0", "/images/0", "/cameras/0", "/materials/0",
          "/materials/0/pbrMetallicRoughness"}) {
        Json& object = json[Json::json_pointer(place)];
        object["extensions"]["X_y"] = Json::object();
        object["strange"] = 1;
        object["name"] = "a label";
        object["extras"] = {{"anything", 1}};
    }
    json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["extensions"]
        ["KHR_texture_transform"] = {{"scale", {1, 1}}, {"shear", 1}};
    json["animations"] = Json::parse("[{}, {}, {}]");
    json["skins"] = Json::array({Json::object()});
    json["materials"][0]["occlusionTexture"] = {{"index", 0}};
    json["asset"]["strange"] = 1; // of whoever wrote the file
    json["extensionsUsed"] = {"Z_w"};
    json["meshes"][0]["primitives"][0]["attributes"]["_CUSTOM"] = 0;
    json["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_3"] = 0;
    const LoadedScene loaded = load(writer);
    const std::vector<std::string> expected{"glTF accessor extension X_y (1)",
                                            "glTF accessor strange (1)",
                                            "glTF animations (3)",
                                            "glTF attribute _CUSTOM (1)",
                                            "glTF bufferView extension X_y (1)",
                                            "glTF bufferView strange (1)",
                                            "glTF camera extension X_y (1)",
                                            "glTF camera strange (1)",
                                            "glTF extension X_y (1)",
                                            "glTF image extension X_y (1)",
                                            "glTF image strange (1)",
                                            "glTF material extension X_y (2)",
                                            "glTF material occlusionTexture (1)",
                                            "glTF material strange (2)",
                                            "glTF mesh extension X_y (1)",
                                            "glTF mesh strange (1)",
                                            "glTF node extension X_y (1)",
                                            "glTF node skin (2)",
                                            "glTF node strange (1)",
                                            "glTF node weights (1)",
                                            "glTF primitive extension X_y (1)",
                                            "glTF primitive strange (1)",
                                            "glTF sampler extension X_y (1)",
                                            "glTF sampler strange (1)",
                                            "glTF scene extension X_y (1)",
                                            "glTF scene strange (1)",
                                            "glTF skins (1)",
                                            "glTF strange (1)",
                                            "glTF texture extension X_y (1)",
                                            "glTF texture strange (1)",
                                            "glTF texture transform shear (1)",
                                            "glTF textures where the mesh has no TEXCOORD_0 (1)"};
    EXPECT_EQ(loaded.ignored, expected);
}

TEST_F(Gltf, NamesTexturesThatCannotShow) {
    GltfWriter writer = textured({{"uri", "data:image/png;base64,AAAA"}});
    writer.node({{"mesh", 0}});
    writer.json["textures"].push_back(Json::object());
    writer.json["materials"][0]["emissiveTexture"] = {{"index", 1}};
    const std::vector<std::string> ignored = load(writer).ignored;
    EXPECT_EQ(std::count(ignored.begin(), ignored.end(), "glTF texture without source (1)"), 1);
    EXPECT_EQ(std::count(ignored.begin(), ignored.end(),
                         "glTF textures where the mesh has no TEXCOORD_0 (1)"),
              1);
}

TEST_F(Gltf, NamesPointsAndLinesAndOtherScenes) {
    GltfWriter writer;
    writer.triangle();
    const Json attributes = {{"POSITION", 0}};
    for (const int mode : {0, 1, 2, 3}) writer.mesh({{"attributes", attributes}, {"mode", mode}});
    writer.json["scenes"].push_back({{"nodes", {0}}});
    EXPECT_EQ(load(writer).ignored, (std::vector<std::string>{"glTF primitive of lines (3)",
                                                              "glTF primitive of points (1)",
                                                              "glTF scenes but one (1)"}));
}

TEST(GltfMembers, ExtensionsThatMayBeRequired) {
    for (const char* name :
         {"EXT_mesh_gpu_instancing", "KHR_lights_punctual", "KHR_materials_emissive_strength",
          "KHR_materials_ior", "KHR_materials_specular", "KHR_materials_unlit",
          "KHR_mesh_quantization", "KHR_node_visibility", "KHR_texture_transform"})
        EXPECT_TRUE(knowsGltfExtension(name)) << name;
    EXPECT_FALSE(knowsGltfExtension("KHR_texture_basisu"));
    EXPECT_FALSE(knowsGltfExtension(""));
}

/// Zeros would be shown where an extension has the data.
TEST_F(Gltf, GeometryInAnUnknownExtensionIsAnError) {
    const auto hide = [](GltfWriter& w) {
        w.json["accessors"][0].erase("bufferView");
        w.json["meshes"][0]["primitives"][0]["extensions"]["X_packed"] = Json::object();
    };
    EXPECT_EQ(errorOf(hide), ": meshes[0].primitives[0] has its geometry in the extension "
                             "'X_packed', which is not known here");
    EXPECT_EQ(errorOf([](auto& w) {
                  w.json["accessors"][0].erase("bufferView");
                  w.json["accessors"][0]["extensions"]["X_packed"] = Json::object();
              }),
              ": accessors[0] has its data in the extension 'X_packed', which is not known here");
    EXPECT_EQ(errorOf([](auto& w) {
                  w.json["bufferViews"][0]["buffer"] = 1;
                  w.json["bufferViews"][0]["extensions"]["X_packed"] = Json::object();
                  w.json["more buffers"] = Json::array({{{"byteLength", 36}}});
              }),
              ": bufferViews[0] has its data in the extension 'X_packed', which is not known here");
    // With a fallback that can be read it is but named.
    GltfWriter writer;
    writer.triangle();
    writer.json["meshes"][0]["primitives"][0]["extensions"]["X_packed"] = Json::object();
    EXPECT_EQ(load(writer).ignored,
              std::vector<std::string>{"glTF primitive extension X_packed (1)"});
}

TEST_F(Gltf, BuffersThatNothingRefersToMayBeMissing) {
    GltfWriter writer;
    writer.triangle();
    writer.json["more buffers"] =
        Json::array({{{"byteLength", 64}}, {{"byteLength", 64}, {"uri", "none.bin"}}});
    const LoadedScene loaded = load(writer);
    EXPECT_EQ(loaded.scene.mesh.triangles.size(), 1u);
    EXPECT_TRUE(loaded.ignored.empty());
    writer.json["bufferViews"][0]["buffer"] = 1;
    EXPECT_EQ(error("a.gltf", writer.embedded()),
              ": buffers[1] has neither a uri nor a binary chunk");
    writer.json["bufferViews"][0]["buffer"] = 2;
    EXPECT_EQ(error("a.gltf", writer.embedded()),
              ": buffers[2] is in a file that is not there: 'none.bin'");
}

/// KHR_mesh_quantization: what gltfpack writes.
TEST_F(Gltf, ReadsQuantizedVertices) {
    const auto positionsOf = [this](auto values, int type, bool normalized) {
        GltfWriter writer;
        const size_t positions = writer.accessor("VEC3", type, 3, values);
        writer.json["accessors"][positions]["normalized"] = normalized;
        if (sizeof values[0] == 1) { // vertices begin at multiples of 4 bytes
            std::string padded;
            for (size_t i = 0; i < values.size(); ++i) {
                padded += (char) values[i];
                if (i % 3 == 2) padded += '\0';
            }
            const size_t view = writer.view(padded);
            writer.json["bufferViews"][view]["byteStride"] = 4;
            writer.json["accessors"][positions]["bufferView"] = view;
        }
        writer.node({{"mesh", writer.mesh({{"attributes", {{"POSITION", positions}}}})}});
        writer.json["extensionsRequired"] = {"KHR_mesh_quantization"};
        return load(writer).scene.mesh.positions;
    };
    using Points = std::vector<glm::vec3>;
    EXPECT_EQ(positionsOf(std::vector<int8_t>{-64, 0, 0, 64, 0, 0, 0, 64, 1}, 5120, false),
              (Points{{-64, 0, 0}, {64, 0, 0}, {0, 64, 1}}));
    EXPECT_EQ(positionsOf(std::vector<int8_t>{-128, 0, 0, 127, 0, 0, 0, 127, -127}, 5120, true),
              (Points{{-1, 0, 0}, {1, 0, 0}, {0, 1, -1}}));
    EXPECT_EQ(positionsOf(std::vector<uint16_t>{0, 0, 0, 65535, 0, 0, 0, 13107, 0}, 5123, true),
              (Points{{0, 0, 0}, {1, 0, 0}, {0, 0.2f, 0}}));
    EXPECT_EQ(positionsOf(std::vector<int16_t>{0, 0, 0, -3000, 0, 0, 0, 9, 0}, 5122, false),
              (Points{{0, 0, 0}, {-3000, 0, 0}, {0, 9, 0}}));
}

} // namespace
} // namespace dirt
