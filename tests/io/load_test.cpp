#include "core/io/load.h"
#include "tests/io/input_error.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/write_image.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

namespace dirt {
namespace {

const std::string kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

class Load : public testing::Test {
protected:
    LoadedScene loadObj(const std::string& text) {
        return loadScene(folder_.write("test.obj", text));
    }
    LoadedScene loadXml(const std::string& content) {
        return loadScene(folder_.write("test.scene", "<world>\n" + content + "\n</world>"));
    }
    std::string error(const std::string& name, LoadOptions options = {}) {
        const std::string file = (folder_.path() / name).string();
        const std::string what = inputError([&] { loadScene(file, options); });
        return what.rfind(file, 0) == 0 ? what.substr(file.size()) : what;
    }
    std::string path(const std::string& name) { return (folder_.path() / name).string(); }

    void writeRedTexture(const std::string& name) {
        std::filesystem::create_directories((folder_.path() / name).parent_path());
        test::writeImage(path(name), 1, 1, 3, {255, 0, 0});
    }

    test::TemporaryFolder folder_;
};

TEST_F(Load, ABareObjHasNeitherCameraNorLight) {
    const LoadedScene loaded = loadObj(kTriangle);
    EXPECT_FALSE(loaded.hasCamera);
    EXPECT_FALSE(loaded.hasLight);
    EXPECT_EQ(loaded.scene.name, "test");
    EXPECT_EQ(loaded.scene.mesh.triangles, (std::vector<Corners>{{0, 1, 2}}));
    EXPECT_EQ(loaded.scene.mesh.materials, std::vector<uint32_t>{0});
    ASSERT_EQ(loaded.scene.materials.size(), 1u);
    EXPECT_TRUE(loaded.warnings.empty());
}

TEST_F(Load, TheExtensionTellsTheFormat) {
    folder_.write("A.OBJ", kTriangle);
    folder_.write("b.ply", "ply");
    EXPECT_EQ(error("A.OBJ"), "");
    EXPECT_EQ(error("b.ply"), ": is no .scene, .obj, .gltf or .glb file");
    EXPECT_EQ(error("none.obj"), ": no such file");
    EXPECT_EQ(error("none.scene"), ": no such file");
}

TEST_F(Load, NeedsTriangles) {
    folder_.write("a.obj", "v 0 0 0\np 1\nl 1 1\n");
    folder_.write("b.obj", "");
    folder_.write("c.scene", "<world/>");
    folder_.write("d.scene", "<world><object file='b.obj'/></world>");
    for (const char* name : {"a.obj", "b.obj", "c.scene", "d.scene"})
        EXPECT_EQ(error(name), ": holds no triangles") << name;
    folder_.write("e.obj", kTriangle.substr(0, kTriangle.find('f')) + "f 1 2\n");
    EXPECT_EQ(error("e.obj"), ": holds no triangles (" + path("e.obj") +
                                  ":4: a face needs 3 corners, not 2: it is skipped)");
}

/// A square whose faults nobody needs to know to show it: all are loaded with their own normals and
/// one warning, which --strict makes an error.
TEST_F(Load, FaultsInWhatAPictureCanDoWithoutAreWarnings) {
    const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
    for (const char* rest : {"f 1//1 2//2 3//3 4//4\n", "vn 1.#QNAN 0 0\nf 1//1 2//1 3//1 4//1\n",
                             "vn -nan(ind) -nan(ind) 1\nf 1//1 2//1 3//1 4//1\n",
                             "vn 0 0 0\nf 1//1 2//1 3//1 4\n", "vt nan nan\nf 1/1 2/1 3/1 4/1\n",
                             "vt 0 0\nf 1/0 2/0 3/0 4/0\n", "v nan nan nan\nf 1 2 3 4\n",
                             "v 0 1e40 0\nf 1 2 3 4\n", "f 1\nf 1 2 3 4\n", "f 1 2\nf 1 2 3 4\n"}) {
        const LoadedScene loaded = loadObj(square + rest);
        const Corners none{kNoIndex, kNoIndex, kNoIndex};
        EXPECT_EQ(loaded.scene.mesh.triangles, (std::vector<Corners>{{0, 1, 2}, {0, 2, 3}}))
            << rest;
        EXPECT_EQ(loaded.scene.mesh.normalIndices, (std::vector<Corners>{none, none})) << rest;
        EXPECT_EQ(loaded.scene.mesh.texcoordIndices, (std::vector<Corners>{none, none})) << rest;
        ASSERT_EQ(loaded.warnings.size(), 1u) << rest;
        LoadOptions strict;
        strict.strict = true;
        EXPECT_EQ(path("test.obj") + error("test.obj", strict), loaded.warnings[0].text) << rest;
    }
    // As small as a normal may be.
    EXPECT_TRUE(loadObj(square + "vn 1e-30 0 1e-30\nf 1//1 2//1 3//1\n").warnings.empty());
}

/// Each position has its colour; those of files without colours are white.
TEST_F(Load, ReadsVertexColours) {
    folder_.write("plain.obj", kTriangle);
    folder_.write("colours.obj", "v 0 0 0 0 0 0\nv 5 5 5 1 1 1\nv 0 0 1 0 0 1\nv 0 1 0 1 1 0\n"
                                 "f 1 3 4\n");
    const Mesh mesh = loadXml("<object file='plain.obj'/><object file='colours.obj'/>"
                              "<object file='plain.obj'/>")
                          .scene.mesh;
    const glm::vec3 white(1.0f);
    EXPECT_EQ(mesh.colors,
              (std::vector<glm::vec3>{
                  white, white, white, glm::vec3(0), {0, 0, 1}, {1, 1, 0}, white, white, white}));
    EXPECT_EQ(mesh.positions.size(), 9u);
    EXPECT_TRUE(loadObj(kTriangle).scene.mesh.colors.empty());
    EXPECT_TRUE(
        loadObj("v 0 0 0 1 1 1\nv 1 0 0 1 1 1\nv 0 1 0\nf 1 2 3\n").scene.mesh.colors.empty())
        << "white needs none";
}

TEST_F(Load, CountsIdsThroughFacesAndTheirTriangles) {
    const LoadedScene loaded = loadObj("v 0 0 0\nv 2 0 0\nv 2 2 0\nv 1 .5 0\no first\nf 1 2 3 4\n"
                                       "o second\nf 3 2 1\nl 1 2\nf 1 1 1\n");
    const Mesh& mesh = loaded.scene.mesh;
    // The quad is concave at its last corner: the cut goes from there.
    EXPECT_EQ(mesh.triangles, (std::vector<Corners>{{1, 2, 3}, {1, 3, 0}, {2, 1, 0}, {0, 0, 0}}));
    EXPECT_EQ(mesh.normalIndices.size(), 4u);
    EXPECT_EQ(mesh.texcoordIndices.size(), 4u);
    EXPECT_EQ(mesh.materials.size(), 4u);
}

TEST_F(Load, LeavesUnusedVerticesOut) {
    const LoadedScene loaded = loadObj("v 9 9 9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 2 3 4\n");
    EXPECT_EQ(loaded.scene.mesh.positions,
              (std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
}

TEST_F(Load, NormalsAreAllOrNone) {
    const LoadedScene loaded =
        loadObj("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 2\nvn 0 0 0\nvn nan 0 1\nvn 0 3 4\n"
                "f 1//1 2//1 3//4\nf 1//1 2//1 3\nf 1//1 2//2 3//1\nf 1//1 2//1 3//3\n");
    const Mesh& mesh = loaded.scene.mesh;
    constexpr Corners kNoCorners = {kNoIndex, kNoIndex, kNoIndex};
    EXPECT_EQ(mesh.normalIndices,
              (std::vector<Corners>{{0, 0, 1}, kNoCorners, kNoCorners, kNoCorners}));
    EXPECT_EQ(mesh.normals, (std::vector<glm::vec3>{{0, 0, 1}, {0, 0.6f, 0.8f}}));
}

TEST_F(Load, TextureCoordinatesAreAllOrNone) {
    const LoadedScene loaded = loadObj("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt .5 .25\nvt inf 0\n"
                                       "f 1/1 2/1 3/1\nf 1/1 2/1 3\nf 1/1 2/2 3/1\n");
    constexpr Corners kNoCorners = {kNoIndex, kNoIndex, kNoIndex};
    EXPECT_EQ(loaded.scene.mesh.texcoordIndices,
              (std::vector<Corners>{{0, 0, 0}, kNoCorners, kNoCorners}));
}

TEST_F(Load, ReadsMaterialsAndTextures) {
    writeRedTexture("Maps/Red Wall.png");
    folder_.write("My Library.mtl", "newmtl unused\nmap_Kd none.png\n"
                                    "newmtl wall\nKd 0 0 0\nmap_Kd maps\\red wall.PNG\n"
                                    "newmtl lamp\nKd .1 .2 .3\nKe 5 5 5\n"
                                    "newmtl other\nmap_Kd -s 1 1 1 Maps/Red Wall.png\n");
    const LoadedScene loaded = loadObj("mtllib my library.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\n"
                                       "usemtl lamp\nf 1 2 3\nusemtl wall\nf 1 2 3\n"
                                       "usemtl other\nf 1 2 3\nusemtl lamp\nf 1 2 3\n");
    EXPECT_TRUE(loaded.warnings.empty());
    const Scene& scene = loaded.scene;
    ASSERT_EQ(scene.materials.size(), 3u); // those that are used, in the order of their names
    EXPECT_EQ(scene.mesh.materials, (std::vector<uint32_t>{0, 1, 2, 0}));
    EXPECT_EQ(scene.materials[0].name, "lamp");
    EXPECT_EQ(scene.materials[0].diffuse, glm::vec3(.1f, .2f, .3f));
    EXPECT_EQ(scene.materials[0].emission, glm::vec3(5));
    EXPECT_EQ(scene.materials[0].diffuseMap, kNoTexture);
    ASSERT_EQ(scene.textures.size(), 1u); // named twice, loaded once
    EXPECT_EQ(scene.materials[1].diffuseMap, 0u);
    EXPECT_EQ(scene.materials[2].diffuseMap, 0u);
    EXPECT_EQ(scene.textures[0].sample({0, 0}), glm::vec3(1, 0, 0));
}

TEST_F(Load, SeveralLibrariesOnALine) {
    folder_.write("a.mtl", "newmtl m\nKd 1 0 0\n");
    folder_.write("b.mtl", "newmtl m\nKd 0 1 0\nnewmtl n\nKd 0 0 1\n");
    const LoadedScene loaded =
        loadObj("mtllib a.mtl none.mtl b.mtl\nusemtl m\n" + kTriangle + "usemtl n\nf 1 2 3\n");
    ASSERT_EQ(loaded.warnings.size(), 1u);
    EXPECT_EQ(loaded.warnings[0].text, path("test.obj") + ":1: material file 'none.mtl' not found");
    EXPECT_EQ(loaded.scene.materials[0].diffuse, glm::vec3(1, 0, 0)); // the first counts
    EXPECT_EQ(loaded.scene.materials[1].diffuse, glm::vec3(0, 0, 1));
}

TEST_F(Load, TheLibraryOfTheModelsNameStandsInForAMissingOne) {
    folder_.write("test.mtl", "newmtl m\nKd 1 0 0\n");
    const std::string text = "usemtl m\n" + kTriangle;
    const LoadedScene loaded = loadObj("mtllib gone.mtl\n" + text);
    EXPECT_EQ(loaded.scene.materials[0].diffuse, glm::vec3(1, 0, 0));
    ASSERT_EQ(loaded.warnings.size(), 1u);
    EXPECT_EQ(loaded.warnings[0].text, path("test.obj") + ":1: material file 'gone.mtl' not found; "
                                                          "'test.mtl' stands in");
    EXPECT_EQ(loadObj(text).warnings.size(), 1u) << "no library is named: no material is defined";
}

TEST_F(Load, WarnsOnceOfEachThingThatIsMissing) {
    folder_.write("damaged.png", "no image");
    folder_.write("a.mtl", "newmtl a\nKd 0 0 0\nmap_Kd none.png\n\nnewmtl b\nmap_Kd none.png\n"
                           "newmtl c\nKd 0 0 0\nmap_Kd damaged.png\n");
    const std::string text = "mtllib a.mtl\nmtllib no such.mtl\nmtllib no such.mtl\n" + kTriangle +
                             "usemtl x\nf 1 2 3\nusemtl a\nf 1 2 3\nusemtl b\nf 1 2 3\n"
                             "usemtl c\nf 1 2 3\nusemtl x\nf 1 2 3\n";
    const LoadedScene loaded = loadObj(text);
    ASSERT_EQ(loaded.warnings.size(), 4u);
    EXPECT_EQ(loaded.warnings[0].kind, WarningKind::missingMaterialLibrary);
    EXPECT_EQ(loaded.warnings[0].text,
              path("test.obj") + ":2: material file 'no such.mtl' not found");
    EXPECT_EQ(loaded.warnings[1].kind, WarningKind::undefinedMaterial);
    EXPECT_EQ(loaded.warnings[1].text, path("test.obj") + ":8: material 'x' is not defined");
    EXPECT_EQ(loaded.warnings[2].kind, WarningKind::unusableTexture);
    EXPECT_EQ(loaded.warnings[2].text, path("a.mtl") + ":3: texture 'none.png' not found");
    EXPECT_EQ(loaded.warnings[3].kind, WarningKind::unusableTexture);
    EXPECT_EQ(loaded.warnings[3].text.rfind(path("a.mtl") + ":9: texture 'damaged.png': ", 0), 0u);
    for (const Material& material : loaded.scene.materials) {
        EXPECT_EQ(material.diffuse, Material().diffuse) << material.name;
        EXPECT_EQ(material.diffuseMap, kNoTexture);
    }
}

TEST_F(Load, StrictMakesThemErrors) {
    const LoadOptions strict{.strict = true};
    folder_.write("a.obj", "mtllib none.mtl\n" + kTriangle);
    folder_.write("b.obj", kTriangle + "usemtl x\nf 1 2 3\n");
    folder_.write("c.obj", "mtllib c.mtl\nusemtl c\n" + kTriangle);
    folder_.write("c.mtl", "newmtl c\nmap_Kd none.png\n");
    EXPECT_EQ(error("a.obj", strict), ":1: material file 'none.mtl' not found");
    EXPECT_EQ(error("b.obj", strict), ":5: material 'x' is not defined");
    EXPECT_EQ(error("c.obj", strict), path("c.mtl") + ":2: texture 'none.png' not found");
    EXPECT_EQ(error("c.obj"), "");
}

TEST_F(Load, ReadsASceneFile) {
    folder_.write("Models/a.obj", kTriangle);
    folder_.write("b.obj", kTriangle);
    const LoadedScene loaded =
        loadXml("<directory path='models'/><directory path='sky'/><tracing buckets='7'/>\n"
                "<light position='0 5 0' target='0 0 0'/><user position='0 0 5' lookat='0 0 0'/>\n"
                "<object file='b.obj'/><transformation translation='0 0 2'><object file='A.obj'/>\n"
                "</transformation>");
    EXPECT_TRUE(loaded.hasCamera);
    EXPECT_TRUE(loaded.hasLight);
    EXPECT_EQ(loaded.settings.bins, 7);
    EXPECT_EQ(loaded.scene.lights.size(), 1u);
    EXPECT_EQ(loaded.scene.camera.eye, glm::vec3(0, 0, 5));
    const Mesh& mesh = loaded.scene.mesh;
    EXPECT_EQ(mesh.triangles, (std::vector<Corners>{{0, 1, 2}, {3, 4, 5}}));
    EXPECT_EQ(mesh.positions[1], glm::vec3(1, 0, 0));
    EXPECT_EQ(mesh.positions[4], glm::vec3(1, 0, 2));
    EXPECT_EQ(loaded.scene.materials.size(), 1u); // one stand-in for both files
}

TEST_F(Load, NamesTheElementWhoseObjectIsMissing) {
    folder_.write("a.scene", "<world>\n<directory path='x'/>\n\n<object file='a.obj'/></world>");
    EXPECT_EQ(error("a.scene"), ":4: object file 'a.obj' not found");
}

/// One file may be placed with two sides and with one; a mirror image keeps its front.
TEST_F(Load, SurfacesHaveOneSideWhereTheSceneSaysSo) {
    folder_.write("a.obj", kTriangle);
    const LoadedScene loaded =
        loadXml("<object file='a.obj'/><object file='a.obj' double_sided='false'/>"
                "<transformation scale='1 1 -1'><object file='a.obj' double_sided='false'/>"
                "</transformation>");
    const Scene& scene = loaded.scene;
    ASSERT_EQ(scene.mesh.triangles.size(), 3u);
    for (size_t i = 0; i < 3; ++i)
        EXPECT_EQ(scene.materials[scene.mesh.materials[i]].doubleSided, i == 0);
    EXPECT_EQ(scene.materials.size(), 2u);
    EXPECT_TRUE(loaded.ignored.empty());
    // Seen from +Z the first ones' corners are counterclockwise, that of the mirror image
    // clockwise.
    const auto along = [&](size_t i) {
        const auto& p = scene.mesh.positions;
        const Corners& c = scene.mesh.triangles[i];
        return glm::cross(p[c[1]] - p[c[0]], p[c[2]] - p[c[0]]).z;
    };
    EXPECT_GT(along(0), 0.0f);
    EXPECT_GT(along(1), 0.0f);
    EXPECT_LT(along(2), 0.0f);
}

TEST_F(Load, RoundsPositionsOnce) {
    folder_.write("a.obj", "v 0.1 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const LoadedScene loaded =
        loadXml("<transformation scale='3 1 1'><object file='a.obj'/></transformation>");
    // 0.1f * 3 is another float: 0.3 + 4.5e-9, where floats are 3e-8 apart.
    EXPECT_EQ(loaded.scene.mesh.positions[0].x, (float) (0.1 * 3.0));
    folder_.write("b.obj", "v 16777217 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const LoadedScene exact = loadXml("<transformation translation='-16777216 0 0'>"
                                      "<object file='b.obj'/></transformation>");
    EXPECT_EQ(exact.scene.mesh.positions[0].x, 1.0f); // 2^24 + 1 is no float
}

TEST_F(Load, TurnsNormalsWithTheirSurface) {
    // A slope of 45 degrees, and its normal, under a scale that is not uniform and a mirror.
    folder_.write("a.obj", "v 0 0 0\nv 0 0 1\nv 1 1 0\nvn 1 -1 0\nf 1//1 2//1 3//1\n");
    for (const std::string scale : {"1 2 1", "-1 2 1", "3 -0.5 7", "1 1 -1", "-1 -1 -1"}) {
        const LoadedScene loaded = loadXml("<transformation rotation='30 1 2 3' scale='" + scale +
                                           "'><object file='a.obj'/></transformation>");
        const Mesh& mesh = loaded.scene.mesh;
        const glm::dvec3 a(mesh.positions[0]), b(mesh.positions[1]), c(mesh.positions[2]);
        const glm::dvec3 n(mesh.normals[0]);
        // Float32 components: each product carries a relative error of 2^-23 at most.
        EXPECT_LT(std::abs(glm::dot(n, b - a)), 3 * 0x1p-23 * glm::length(b - a)) << scale;
        EXPECT_LT(std::abs(glm::dot(n, c - a)), 3 * 0x1p-23 * glm::length(c - a)) << scale;
        EXPECT_NEAR(glm::length(n), 1.0, 0x1p-23) << scale;
    }
    // The side is kept: what the normal pointed to, it still points to after mirroring.
    const LoadedScene mirrored =
        loadXml("<transformation scale='-1 1 1'><object file='a.obj'/></transformation>");
    EXPECT_LT(mirrored.scene.mesh.normals[0].x, 0.0f);
    EXPECT_LT(mirrored.scene.mesh.normals[0].y, 0.0f);
}

TEST_F(Load, FlattenedGeometryIsKept) {
    folder_.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\n");
    const LoadedScene loaded =
        loadXml("<transformation scale='1 1 0'><object file='a.obj'/></transformation>"
                "<transformation scale='0 0 0'><object file='a.obj'/></transformation>");
    const Mesh& mesh = loaded.scene.mesh;
    ASSERT_EQ(mesh.triangles.size(), 2u);
    EXPECT_EQ(mesh.normals, (std::vector<glm::vec3>{{0, 0, 1}}));
    EXPECT_EQ(mesh.normalIndices[1][0], kNoIndex);
}

TEST_F(Load, RefusesPositionsThatATransformMakesInfinite) {
    folder_.write("a.obj", "v 1e30 0 0\nv 1 0 0\nv 0 1 0\n\nf 1 2 3\n");
    folder_.write("a.scene", "<world><transformation scale='1e30 1 1'>"
                             "<object file='a.obj'/></transformation></world>");
    EXPECT_EQ(error("a.scene"),
              path("a.obj") + ":5: vertex 1 does not fit in float32 after its transformation");
}

} // namespace
} // namespace dirt
