// Damaged glTF files: each is refused in one line that names what is wrong.

#include "tests/io/gltf_fixture.h"

namespace dirt {
namespace {

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
            attribute("POSITION", w.template accessor<uint32_t>("VEC3", 5125, 3, {0, 0, 0}))(w);
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
