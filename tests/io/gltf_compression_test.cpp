// glTF files whose geometry Draco or meshoptimizer packed: written with these libraries' encoders
// where the build has them; refused in one line, or read from the plain fallback, where it has not.

#include "tests/io/gltf_fixture.h"
#include "tests/support/processor_time.h"

#ifdef DIRT_HAVE_DRACO
#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#endif
#ifdef DIRT_HAVE_MESHOPT
#include <meshoptimizer.h>
#endif

namespace dirt {
namespace {

/// A triangle whose accessors are empty, and whose data is in a Draco view of the given bytes.
GltfWriter dracoFile(const std::string& bytes) {
    GltfWriter writer;
    writer.triangle();
    writer.json["accessors"] = Json::array(
        {{{"componentType", 5126}, {"count", 3}, {"type", "VEC3"}},
         {{"componentType", 5125}, {"count", 3}, {"type", "SCALAR"}},
         {{"componentType", 5121}, {"count", 3}, {"type", "VEC2"}, {"normalized", true}}});
    Json& primitive = writer.json["meshes"][0]["primitives"][0];
    primitive["attributes"] = {{"POSITION", 0}, {"TEXCOORD_0", 2}};
    primitive["indices"] = 1;
    primitive["extensions"]["KHR_draco_mesh_compression"] = {
        {"bufferView", writer.view(bytes)}, {"attributes", {{"POSITION", 0}, {"TEXCOORD_0", 1}}}};
    return writer;
}

TEST_F(Gltf, DamagedDracoMeshesAreErrors) {
    const std::string what = error("a.gltf", dracoFile(std::string(16, '\0')).embedded());
    EXPECT_EQ(what.rfind(": meshes[0].primitives[0]", 0), 0u) << what;
    EXPECT_NE(what.find("KHR_draco_mesh_compression"), what.npos) << what;
}

#ifdef DIRT_HAVE_DRACO

std::string dracoTriangle() {
    draco::TriangleSoupMeshBuilder builder;
    builder.Start(1);
    const int positions =
        builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
    const int texcoords =
        builder.AddAttribute(draco::GeometryAttribute::TEX_COORD, 2, draco::DT_UINT8);
    const float p[3][3] = {{0, 0, 0}, {4, 0, 0}, {0, 8, 0}};
    const uint8_t t[3][2] = {{0, 0}, {255, 0}, {0, 51}};
    const draco::FaceIndex face(0);
    builder.SetAttributeValuesForFace(positions, face, p[0], p[1], p[2]);
    builder.SetAttributeValuesForFace(texcoords, face, t[0], t[1], t[2]);
    const auto mesh = builder.Finalize();
    draco::Encoder encoder; // without quantization: to the bit
    encoder.SetEncodingMethod(draco::MESH_SEQUENTIAL_ENCODING);
    draco::EncoderBuffer buffer;
    EXPECT_TRUE(encoder.EncodeMeshToBuffer(*mesh, &buffer).ok());
    return {buffer.data(), buffer.size()};
}

TEST_F(Gltf, ReadsDracoMeshes) {
    const std::string bytes = dracoTriangle();
    GltfWriter writer = dracoFile(bytes);
    writer.json["extensionsRequired"] = {"KHR_draco_mesh_compression"};
    const LoadedScene loaded = load(writer);
    const Mesh& mesh = loaded.scene.mesh;
    ASSERT_EQ(mesh.triangles.size(), 1u);
    const Corners& c = mesh.triangles[0];
    const Corners& t = mesh.texcoordIndices[0];
    EXPECT_EQ(mesh.positions[c[0]], glm::vec3(0));
    EXPECT_EQ(mesh.positions[c[1]], glm::vec3(4, 0, 0));
    EXPECT_EQ(mesh.positions[c[2]], glm::vec3(0, 8, 0));
    EXPECT_EQ(mesh.texcoords[t[1]], glm::vec2(1, 1));
    EXPECT_EQ(mesh.texcoords[t[2]], glm::vec2(0, 1.0f - 51.0f / 255.0f));
    EXPECT_TRUE(loaded.ignored.empty());
    for (size_t length = 0; length < bytes.size(); ++length)
        EXPECT_NE(error("a.gltf", dracoFile(bytes.substr(0, length)).embedded()), "") << length;
}

std::string varint(uint32_t value) {
    std::string bytes;
    for (; value >= 128; value >>= 7) bytes += (char) (value | 128);
    return bytes + (char) value;
}

/// Faces are claimed in a few bytes, and the decoder makes its tables before it reads any.
TEST_F(Gltf, DracoMeshesAreNoLargerThanTheirBytes) {
    draco::TriangleSoupMeshBuilder builder;
    builder.Start(2);
    const int positions =
        builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
    const float p[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
    builder.SetAttributeValuesForFace(positions, draco::FaceIndex(0), p[0], p[1], p[2]);
    builder.SetAttributeValuesForFace(positions, draco::FaceIndex(1), p[2], p[1], p[3]);
    const auto mesh = builder.Finalize();
    draco::Encoder encoder;
    encoder.SetEncodingMethod(draco::MESH_EDGEBREAKER_ENCODING);
    draco::EncoderBuffer buffer;
    ASSERT_TRUE(encoder.EncodeMeshToBuffer(*mesh, &buffer).ok());
    const std::string bytes(buffer.data(), buffer.size());
    // Vertices, faces, sets of attributes, symbols.
    ASSERT_EQ(bytes.substr(12, 4), std::string("\4\2\0\2", 4));
    const auto claiming = [&](uint32_t count) {
        const std::string number = varint(count);
        GltfWriter writer = dracoFile(bytes.substr(0, 12) + number + number + bytes[14] + number +
                                      bytes.substr(16));
        writer.json["meshes"][0]["primitives"][0]["attributes"] = {{"POSITION", 0}};
        return writer.embedded();
    };
    for (const uint32_t count : {20'000'000u, 1'000'000'000u}) {
        std::string what;
        EXPECT_LT(test::processorTime([&] { what = error("a.gltf", claiming(count)); }), 1.0);
        EXPECT_NE(what.find("claims more than its bytes can hold"), what.npos) << what;
    }
    EXPECT_NE(error("a.gltf", claiming(50'000)).find("holds no Draco mesh that can be read"),
              std::string::npos);
    LoadOptions options;
    options.memory = MemoryBudget(1'000'000);
    EXPECT_NE(inputError([&] {
                  loadScene(folder_.write("b.gltf", claiming(50'000)), options);
              }).find("KHR_draco_mesh_compression needs "),
              std::string::npos);
}

#endif

/// A triangle whose positions are in a meshopt view of the given bytes, over a fallback buffer
/// without data.
GltfWriter meshoptFile(const std::string& bytes, const Json& more = Json::object()) {
    GltfWriter writer;
    writer.triangle();
    const size_t packed = writer.view(bytes);
    Json source = {{"buffer", 0},
                   {"byteOffset", writer.json["bufferViews"][packed]["byteOffset"]},
                   {"byteLength", bytes.size()},
                   {"byteStride", 12},
                   {"count", 3},
                   {"mode", "ATTRIBUTES"}};
    source.update(more);
    writer.json["bufferViews"][0] = {{"buffer", 1}, {"byteLength", 36}};
    writer.json["bufferViews"][0]["extensions"]["EXT_meshopt_compression"] = source;
    Json fallback = {{"byteLength", 36}};
    fallback["extensions"]["EXT_meshopt_compression"] = {{"fallback", true}};
    writer.json["more buffers"] = Json::array({fallback});
    return writer;
}

TEST_F(Gltf, DamagedMeshoptBuffersAreErrors) {
    const std::string what = error("a.gltf", meshoptFile(std::string(16, '\0')).embedded());
    EXPECT_EQ(what.rfind(": bufferViews[0]", 0), 0u) << what;
    EXPECT_NE(what.find("EXT_meshopt_compression"), what.npos) << what;
}

#ifdef DIRT_HAVE_MESHOPT

TEST_F(Gltf, ReadsMeshoptBuffers) {
    const float positions[] = {0, 0, 0, 4, 0, 0, 0, 8, 0};
    std::string bytes(meshopt_encodeVertexBufferBound(3, 12), '\0');
    bytes.resize(
        meshopt_encodeVertexBuffer((unsigned char*) bytes.data(), bytes.size(), positions, 3, 12));
    GltfWriter writer = meshoptFile(bytes);
    writer.json["extensionsRequired"] = {"EXT_meshopt_compression"};
    const LoadedScene loaded = load(writer);
    EXPECT_EQ(loaded.scene.mesh.positions,
              (std::vector<glm::vec3>{{0, 0, 0}, {4, 0, 0}, {0, 8, 0}}));
    EXPECT_TRUE(loaded.ignored.empty()) << loaded.ignored[0];

    const std::string place = ": bufferViews[0].extensions.EXT_meshopt_compression ";
    const auto errorWith = [&](const Json& more) {
        const std::string what = error("a.gltf", meshoptFile(bytes, more).embedded());
        return what.rfind(place, 0) == 0 ? what.substr(place.size()) : what;
    };
    EXPECT_EQ(errorWith({{"mode", "ZIP"}}), "has an unknown mode 'ZIP'");
    EXPECT_EQ(errorWith({{"byteStride", 10}}), "has a byteStride that its mode does not allow");
    EXPECT_EQ(errorWith({{"mode", "TRIANGLES"}}), "has a byteStride that its mode does not allow");
    EXPECT_EQ(errorWith({{"filter", "QUATERNION"}}),
              "has a filter that its mode and byteStride do not allow");
    EXPECT_EQ(errorWith({{"count", 4'000'000'000}}), "claims more than its bytes can hold");
    for (size_t length = 0; length < bytes.size(); ++length)
        EXPECT_NE(error("a.gltf", meshoptFile(bytes.substr(0, length)).embedded()), "") << length;
}

TEST_F(Gltf, ReadsMeshoptFiltersAndIndices) {
    // 2^E * M in 32 bits: exponent -1 and mantissas twice the values.
    uint32_t packed[9] = {};
    const int values[] = {0, 0, 0, 8, 0, 0, 0, 16, 0};
    for (int i = 0; i < 9; ++i) packed[i] = 0xffu << 24 | (uint32_t) values[i];
    std::string bytes(meshopt_encodeVertexBufferBound(3, 12), '\0');
    bytes.resize(
        meshopt_encodeVertexBuffer((unsigned char*) bytes.data(), bytes.size(), packed, 3, 12));
    GltfWriter writer = meshoptFile(bytes, {{"filter", "EXPONENTIAL"}});
    const unsigned int corners[] = {2, 1, 0};
    std::string indices(meshopt_encodeIndexSequenceBound(3, 3), '\0');
    indices.resize(
        meshopt_encodeIndexSequence((unsigned char*) indices.data(), indices.size(), corners, 3));
    const size_t index = writer.indices<uint16_t>({0, 0, 0}), source = writer.view(indices);
    Json& view =
        writer.json["bufferViews"][writer.json["accessors"][index]["bufferView"].get<size_t>()];
    view["extensions"]["EXT_meshopt_compression"] = {
        {"buffer", 0},       {"byteOffset", writer.json["bufferViews"][source]["byteOffset"]},
        {"byteStride", 2},   {"byteLength", indices.size()},
        {"mode", "INDICES"}, {"count", 3}};
    writer.json["meshes"][0]["primitives"][0]["indices"] = index;
    EXPECT_EQ(load(writer).scene.mesh.positions,
              (std::vector<glm::vec3>{{0, 8, 0}, {4, 0, 0}, {0, 0, 0}}));
}

#endif

} // namespace
} // namespace dirt
