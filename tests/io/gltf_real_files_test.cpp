// glTF files of others, as we read them and as tinygltf does.

#include "core/io/gltf.h"
#include "core/io/load.h"
#include "tests/io/test_scenes.h"

#include <gtest/gtest.h>

#include <cstring>

// Compiled here, under another name: libdraco.a, which the library is linked with, may bring a
// tinygltf of its own, of another version.
#include <nlohmann/json.hpp>
#define tinygltf tinygltf_of_the_test
#define TINYGLTF_IMPLEMENTATION
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_INCLUDE_JSON
#include <tiny_gltf.h>

namespace dirt {
namespace {

namespace fs = std::filesystem;

struct RealFile {
    const char* file;
    size_t triangles, materials, textures;
};

void PrintTo(const RealFile& real, std::ostream* out) {
    *out << real.file;
}

class RealGltf : public testing::TestWithParam<RealFile> {};

/// Element \p i of an accessor, as tinygltf has it.
template <typename Value>
Value element(const tinygltf::Model& model, int index, size_t i) {
    const tinygltf::Accessor& accessor = model.accessors.at((size_t) index);
    const tinygltf::BufferView& view = model.bufferViews.at((size_t) accessor.bufferView);
    Value value;
    std::memcpy(&value,
                model.buffers.at((size_t) view.buffer).data.data() + view.byteOffset +
                    accessor.byteOffset + i * (size_t) accessor.ByteStride(view),
                sizeof value);
    return value;
}

uint32_t indexAt(const tinygltf::Model& model, int index, size_t i) {
    switch (model.accessors.at((size_t) index).componentType) {
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return element<uint8_t>(model, index, i);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return element<uint16_t>(model, index, i);
    default:
        return element<uint32_t>(model, index, i);
    }
}

TEST_P(RealGltf, AgreesWithTinygltf) {
    const fs::path file = scenesFolder() / GetParam().file;
    if (!fs::exists(file)) GTEST_SKIP() << "no " << file;
    LoadReport report;
    const GltfFile ours = readGltf(file, report);
    tinygltf::TinyGLTF reader;
    reader.SetImageLoader( // images are none of its matter
        [](tinygltf::Image*, int, std::string*, std::string*, int, int, const unsigned char*, int,
           void*) { return true; },
        nullptr);
    tinygltf::Model theirs;
    std::string error, warning;
    ASSERT_TRUE(file.extension() == ".glb"
                    ? reader.LoadBinaryFromFile(&theirs, &error, &warning, file.string())
                    : reader.LoadASCIIFromFile(&theirs, &error, &warning, file.string()))
        << error;
    ASSERT_EQ(ours.meshes.size(), theirs.meshes.size());
    size_t different = 0, corners = 0;
    for (size_t m = 0; m < ours.meshes.size(); ++m) {
        size_t own = 0;
        for (const tinygltf::Primitive& primitive : theirs.meshes[m].primitives) {
            if (primitive.mode != TINYGLTF_MODE_TRIANGLES) continue;
            ASSERT_LT(own, ours.meshes[m].size());
            const GltfFile::Primitive& p = ours.meshes[m][own++];
            ASSERT_EQ(p.triangles.size() * 3,
                      theirs.accessors.at((size_t) primitive.indices).count);
            EXPECT_EQ((int) p.surface, primitive.material);
            const auto& attributes = primitive.attributes;
            const bool hasNormals = attributes.count("NORMAL") > 0;
            EXPECT_EQ(p.normals.empty(), !hasNormals);
            for (size_t i = 0; i < p.triangles.size() * 3; ++i, ++corners) {
                const uint32_t corner = p.triangles[i / 3][i % 3];
                different += corner != indexAt(theirs, primitive.indices, i);
                different += p.positions[corner] !=
                             element<glm::vec3>(theirs, attributes.at("POSITION"), corner);
                if (hasNormals)
                    different += p.normals[corner] !=
                                 element<glm::vec3>(theirs, attributes.at("NORMAL"), corner);
                if (!p.texcoords.empty())
                    different += p.texcoords[corner] !=
                                 element<glm::vec2>(theirs, attributes.at("TEXCOORD_0"), corner);
            }
        }
        EXPECT_EQ(own, ours.meshes[m].size());
    }
    EXPECT_EQ(different, 0u);
    EXPECT_GT(corners, 0u);
    ASSERT_EQ(ours.surfaces.size(), theirs.materials.size());
    for (size_t i = 0; i < ours.surfaces.size(); ++i)
        for (int k = 0; k < 3; ++k)
            EXPECT_EQ(ours.surfaces[i].material.diffuse[k],
                      (float) theirs.materials[i].pbrMetallicRoughness.baseColorFactor[(size_t) k]);
}

TEST_P(RealGltf, Loads) {
    const fs::path file = scenesFolder() / GetParam().file;
    if (!fs::exists(file)) GTEST_SKIP() << "no " << file;
    const LoadedScene loaded = loadScene(file);
    for (const Warning& warning : loaded.warnings) // glass, to be blended, of an alpha below a half
        EXPECT_EQ(warning.kind, WarningKind::unseenMaterial) << warning.text;
    EXPECT_EQ(loaded.scene.mesh.triangles.size(), GetParam().triangles);
    EXPECT_EQ(loaded.scene.materials.size(), GetParam().materials);
    EXPECT_EQ(loaded.scene.textures.size(), GetParam().textures);
}

INSTANTIATE_TEST_SUITE_P(Files, RealGltf,
                         testing::Values(RealFile{"vianney_house_2/scene.gltf", 56674, 14, 2},
                                         RealFile{"assimp/2CylinderEngine.glb", 121496, 34, 0}),
                         [](const auto& info) { return "File" + std::to_string(info.index); });

} // namespace
} // namespace dirt
