// Files as they are in the field: the scenes of $DIRT_SCENES.

#include "core/io/load.h"
#include "core/io/obj.h"
#include "tests/io/input_error.h"
#include "tests/io/test_scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <tiny_obj_loader.h>

namespace dirt {
namespace {

namespace fs = std::filesystem;

struct RealScene {
    const char* file;
    size_t triangles, materials, textures, warnings;
};

class RealScenes : public testing::TestWithParam<RealScene> {};

/// What every reader of a Mesh relies on.
void expectConsistent(const Scene& scene) {
    const Mesh& mesh = scene.mesh;
    const size_t count = mesh.triangles.size();
    ASSERT_EQ(mesh.normalIndices.size(), count);
    ASSERT_EQ(mesh.texcoordIndices.size(), count);
    ASSERT_EQ(mesh.materials.size(), count);
    const auto inRange = [](uint32_t index, size_t size) {
        return index == kNoIndex || index < size;
    };
    size_t wrong = 0;
    for (size_t i = 0; i < count; ++i) {
        for (size_t k = 0; k < 3; ++k)
            wrong += mesh.triangles[i][k] >= mesh.positions.size() ||
                     !inRange(mesh.normalIndices[i][k], mesh.normals.size()) ||
                     !inRange(mesh.texcoordIndices[i][k], mesh.texcoords.size());
        wrong += mesh.materials[i] >= scene.materials.size();
    }
    for (const Material& material : scene.materials)
        wrong += !inRange(material.diffuseMap, scene.textures.size());
    for (const glm::vec3& n : mesh.normals) wrong += std::fabs(glm::length(n) - 1.0f) > 1e-6f;
    EXPECT_EQ(wrong, 0u);
}

TEST_P(RealScenes, Load) {
    const fs::path file = scenesFolder() / GetParam().file;
    if (!fs::exists(file)) GTEST_SKIP() << "no " << file;
    const LoadedScene loaded = loadScene(file);
    EXPECT_EQ(loaded.scene.mesh.triangles.size(), GetParam().triangles);
    EXPECT_EQ(loaded.scene.materials.size(), GetParam().materials);
    EXPECT_EQ(loaded.scene.textures.size(), GetParam().textures);
    EXPECT_EQ(loaded.warnings.size(), GetParam().warnings);
    expectConsistent(loaded.scene);
}

/// tinyobjloader as an independent reader: the same polygons, materials and numbers. It sums up
/// digits in double, far below half an ulp of float32, so its floats are at most one ulp away.
TEST_P(RealScenes, AgreesWithTinyobjloader) {
    const fs::path file = scenesFolder() / GetParam().file;
    if (!fs::exists(file)) GTEST_SKIP() << "no " << file;
    LoadReport report;
    const ObjFile ours = readObj(file, report);
    tinyobj::attrib_t attributes;
    std::vector<tinyobj::shape_t> shapes;
    std::vector<tinyobj::material_t> materials;
    std::string warning, error;
    ASSERT_TRUE(tinyobj::LoadObj(&attributes, &shapes, &materials, &warning, &error, file.c_str(),
                                 nullptr, false))
        << error;

    ASSERT_EQ(attributes.vertices.size(), ours.positions.size() * 3);
    size_t different = 0;
    for (size_t i = 0; i < attributes.vertices.size(); ++i) {
        const float theirs = attributes.vertices[i], value = (float) ours.positions[i / 3][i % 3];
        const float ulp = std::nextafter(std::fabs(theirs), INFINITY) - std::fabs(theirs);
        different += std::fabs(theirs - value) > ulp;
    }
    EXPECT_EQ(different, 0u);

    size_t face = 0;
    const auto index = [](int i) { return i < 0 ? ObjFile::kNone : (uint32_t) i; };
    for (const tinyobj::shape_t& shape : shapes) {
        size_t corner = 0;
        for (const unsigned count : shape.mesh.num_face_vertices) {
            ASSERT_LT(face, ours.faces.size());
            const ObjFile::Face& f = ours.faces[face++];
            ASSERT_EQ(f.corners, count) << "line " << f.line;
            for (unsigned i = 0; i < count; ++i, ++corner) {
                const ObjFile::Corner& c = ours.corners[f.firstCorner + i];
                const tinyobj::index_t& theirs = shape.mesh.indices[corner];
                different += c.position != index(theirs.vertex_index) ||
                             c.texcoord != index(theirs.texcoord_index) ||
                             c.normal != index(theirs.normal_index);
            }
        }
    }
    EXPECT_EQ(face, ours.faces.size());
    EXPECT_EQ(different, 0u);
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, RealScenes,
    testing::Values(RealScene{"cornell-boxes/CornellBox-Original.obj", 36, 8, 0, 0},
                    RealScene{"cornell-boxes/CornellBox-Mirror.obj", 36, 8, 0, 0},
                    RealScene{"cornell-boxes/CornellBox-Glossy.obj", 1112, 8, 0, 1},
                    RealScene{"cornell-boxes/CornellBox-Sphere.obj", 2188, 8, 0, 0},
                    RealScene{"cornell-boxes/CornellBox-Water.obj", 7088, 9, 0, 0},
                    RealScene{"crytek-sponza/sponza.obj", 279163, 26, 21, 4},
                    RealScene{"conference/conference.obj", 331179, 1, 0, 0},
                    RealScene{"sterngarten/Sterngarten_Wien_innerArea-optimized.obj", 71673, 21, 15,
                              0},
                    RealScene{"forza/forza.obj", 71776, 129, 129, 0},
                    RealScene{"bunny/bunny.obj", 69666, 1, 0, 0},
                    RealScene{"japaneseMaple/japaneseMaple.obj", 198396, 2, 1, 0},
                    RealScene{"bush/bush.obj", 40292, 2, 2, 0}),
    [](const auto& info) {
        return fs::path(info.param.file).parent_path().filename().string().substr(0, 5) +
               std::to_string(info.index);
    });

/// Each odd or broken file loads or ends in one line that names it.
TEST(OddFolders, LoadOrEndInOneLine) {
    const fs::path folder = scenesFolder() / "assimp";
    if (!fs::is_directory(folder)) GTEST_SKIP() << "no " << folder;
    int loadedFiles = 0, refusedFiles = 0;
    for (const char* part : {"OBJ", "invalid"})
        for (const auto& entry : fs::directory_iterator(folder / part)) {
            const std::string what = inputError([&] {
                const LoadedScene loaded = loadScene(entry.path());
                expectConsistent(loaded.scene);
                for (const Warning& warning : loaded.warnings)
                    EXPECT_EQ(warning.text.find('\n'), std::string::npos) << warning.text;
            });
            ++(what.empty() ? loadedFiles : refusedFiles);
            EXPECT_EQ(what.find('\n'), std::string::npos) << what;
            EXPECT_TRUE(what.empty() || what.rfind(entry.path().string() + ":", 0) == 0) << what;
        }
    EXPECT_EQ(loadedFiles, 18);
    EXPECT_EQ(refusedFiles, 33);
}

struct OddFile {
    const char* file;
    size_t triangles, materials, textures, warnings; ///< where it loads
    const char* error = "";                          ///< where it does not: what follows its name
};

void PrintTo(const OddFile& odd, std::ostream* out) {
    *out << odd.file;
}

class OddFiles : public testing::TestWithParam<OddFile> {};

TEST_P(OddFiles, GiveWhatTheyHold) {
    const OddFile& odd = GetParam();
    const fs::path file = scenesFolder() / "assimp" / odd.file;
    if (!fs::exists(file)) GTEST_SKIP() << "no " << file;
    LoadedScene loaded;
    const std::string what = inputError([&] { loaded = loadScene(file); });
    EXPECT_EQ(what, *odd.error ? file.string() + odd.error : "");
    EXPECT_EQ(loaded.scene.mesh.triangles.size(), odd.triangles);
    EXPECT_EQ(loaded.scene.materials.size(), odd.materials);
    EXPECT_EQ(loaded.scene.textures.size(), odd.textures);
    EXPECT_EQ(loaded.warnings.size(), odd.warnings);
}

INSTANTIATE_TEST_SUITE_P(
    Assimp, OddFiles,
    testing::Values(
        OddFile{"OBJ/WusonOBJ.obj", 3732, 1, 0, 0}, OddFile{"OBJ/box.obj", 12, 1, 0, 1},
        OddFile{"OBJ/box_longline.obj", 944, 1, 0, 1},
        OddFile{"OBJ/box_mat_with_spaces.obj", 12, 1, 0, 0},
        OddFile{"OBJ/box_without_lineending.obj", 12, 1, 0, 1},
        OddFile{"OBJ/concave_polygon.obj", 64, 1, 0, 0},
        // The library, which is named after the group, is not there; nor is the material.
        OddFile{"OBJ/cube_mtllib_after_g.obj", 12, 1, 0, 1},
        OddFile{"OBJ/cube_usemtl.obj", 12, 3, 0, 1},
        OddFile{"OBJ/cube_with_vertexcolors.obj", 12, 1, 0, 0},
        OddFile{"OBJ/cube_with_vertexcolors_uni.obj", 12, 1, 0, 0},
        OddFile{"OBJ/empty_mat.obj", 256, 1, 0, 0}, OddFile{"OBJ/multiple_spaces.obj", 1, 1, 0, 0},
        OddFile{"OBJ/regr01.obj", 2710, 12, 0, 0}, OddFile{"OBJ/regr_3429812.obj", 4, 1, 0, 0},
        OddFile{"OBJ/space_in_material_name.obj", 64, 1, 0, 0},
        OddFile{"OBJ/spider.obj", 1368, 4, 4, 1},  // a normal without length
        OddFile{"OBJ/testmixed.obj", 12, 1, 0, 1}, // points and lines between the faces
        OddFile{"OBJ/testline.obj", 0, 0, 0, 0, ": holds no triangles"},
        OddFile{"OBJ/testpoints.obj", 0, 0, 0, 0, ": holds no triangles"},
        OddFile{"OBJ/point_cloud.obj", 0, 0, 0, 0, ": holds no triangles"},
        OddFile{"OBJ/number_formats.obj", 0, 0, 0, 0, ":11: malformed number '3.1+e2'"},
        OddFile{"OBJ/box_UTF16BE.obj", 0, 0, 0, 0,
                ":1: is UTF-16; only ASCII and UTF-8 text can be read"},
        OddFile{"invalid/empty.obj", 0, 0, 0, 0, ": holds no triangles"},
        OddFile{"invalid/malformed.obj", 0, 0, 0, 0, ":23: v index 12 is out of range (8 present)"},
        // A face without corners is skipped; the library is not named.
        OddFile{"invalid/malformed2.obj", 10, 1, 0, 2},
        OddFile{"invalid/empty.ply", 0, 0, 0, 0, ": is no .scene, .obj, .gltf or .glb file"}),
    [](const auto& info) {
        return fs::path(info.param.file).stem().string() + "_" + std::to_string(info.index);
    });

/// A flat ring of one polygon with 64 corners: cut so that it keeps its shape.
TEST(OddFolders, ConcavePolygonKeepsItsShape) {
    const fs::path file = scenesFolder() / "assimp/OBJ/concave_polygon.obj";
    if (!fs::exists(file)) GTEST_SKIP() << "no " << file;
    const Mesh mesh = loadScene(file).scene.mesh;
    glm::dvec3 side(0.0);
    for (const Corners& t : mesh.triangles) {
        const glm::dvec3 a(mesh.positions[t[0]]), b(mesh.positions[t[1]]), c(mesh.positions[t[2]]);
        const glm::dvec3 normal = glm::cross(b - a, c - a);
        if (side == glm::dvec3(0.0)) side = normal;
        EXPECT_GT(glm::dot(side, normal), 0.0) << t[0] << ' ' << t[1] << ' ' << t[2];
    }
}

} // namespace
} // namespace dirt
