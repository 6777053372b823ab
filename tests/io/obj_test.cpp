#include "core/io/obj.h"
#include "tests/io/input_error.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace dirt {
namespace {

const std::string kThreeVertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

class Obj : public testing::Test {
protected:
    ObjFile read(const std::string& text) {
        return readObj(folder_.write("test.obj", text), report_);
    }
    /// The error's text after the file's name: ":line: message".
    std::string error(const std::string& text) {
        const std::string file = folder_.write("test.obj", text);
        const std::string what = inputError([&] { readObj(file, report_); });
        return what.empty() ? what : what.substr(file.size());
    }
    /// Likewise the warnings' texts.
    std::vector<std::string> warnings() const {
        std::vector<std::string> texts;
        for (const Warning& warning : report_.warnings())
            texts.push_back(warning.text.substr((folder_ / "test.obj").size()));
        return texts;
    }
    static std::vector<uint32_t> positionsOf(const ObjFile& obj, size_t face) {
        std::vector<uint32_t> indices;
        for (size_t i = 0; i < obj.faces[face].corners; ++i)
            indices.push_back(obj.corners[obj.faces[face].firstCorner + i].position);
        return indices;
    }

    test::TemporaryFolder folder_;
    LoadReport report_;
};

TEST_F(Obj, ReadsVerticesWithTabsAndWeights) {
    const ObjFile obj = read("v\t1 2\t3\n  v +1. -.5 1e2 1.0\nv 0 0 1 # one\n");
    EXPECT_EQ(obj.positions, (std::vector<glm::dvec3>{{1, 2, 3}, {1, -0.5, 100}, {0, 0, 1}}));
    EXPECT_TRUE(obj.colors.empty());
}

TEST_F(Obj, ReadsTextureCoordinatesOfOneToThreeNumbers) {
    const ObjFile obj = read("vt 0.5\nvt 0.25 0.75\nvt 1 2 3\n");
    EXPECT_EQ(obj.texcoords, (std::vector<glm::dvec2>{{0.5, 0}, {0.25, 0.75}, {1, 2}}));
}

TEST_F(Obj, KeepsAttributesThatAreNotFiniteAndSaysSo) {
    const ObjFile obj = read("vn 0 0 1\nvn nan 0 1\nvn 1.#QNAN 0 0\nvn -nan(ind) 0 1\n"
                             "vn 0 -1.#IND00 1.#R\nvn 0 0 1.#INF\nvt inf 0\nvt 0 1e39\nvn 0 0 0\n");
    EXPECT_TRUE(std::isnan(obj.normals[1].x));
    EXPECT_TRUE(std::isnan(obj.normals[2].x));
    EXPECT_TRUE(std::isinf(obj.texcoords[0].x));
    EXPECT_EQ(warnings(),
              (std::vector<std::string>{
                  ":2: a normal is not finite: triangles with it have their own (5 times)",
                  ":7: texture coordinates are not finite: triangles with them have none (2 times)",
                  ":9: a normal has no length: triangles with it have their own"}));
}

TEST_F(Obj, DecodesColoursFromSrgb) {
    // The first six numbers count; a vertex without a colour is white.
    const ObjFile obj = read("v 0 0 0 0 1 0.5\nv 1 2 3\nv 1 2 3 0.04 0.02 1 0.25\nv 0 0 0 1\n");
    EXPECT_EQ(obj.positions[2], glm::dvec3(1, 2, 3));
    const float half = (float) std::pow((0.5 + 0.055) / 1.055, 2.4);
    EXPECT_EQ(obj.colors,
              (std::vector<glm::vec3>{
                  {0, 1, half}, {1, 1, 1}, {0.04f / 12.92f, 0.02f / 12.92f, 1}, {1, 1, 1}}));
    EXPECT_TRUE(warnings().empty());
}

TEST_F(Obj, TakesWholeNumbersForColoursOf255) {
    const ObjFile obj = read("v 0 0 0 0 1 0\nv 0 0 0 255 51 0\n");
    const float fifth = (float) std::pow((0.2 + 0.055) / 1.055, 2.4);
    EXPECT_EQ(obj.colors[1], glm::vec3(1, fifth, 0));
    EXPECT_FLOAT_EQ(obj.colors[0].y, 1.0f / 255.0f / 12.92f);
    EXPECT_EQ(warnings(), std::vector<std::string>{":2: vertex colours are whole numbers above 1: "
                                                   "they are taken as of 255"});
}

TEST_F(Obj, TakesWhiteForColoursThatAreNone) {
    const ObjFile obj = read("v 0 0 0 1.5 0 0\nv 0 0 0 0 -1 0\nv 0 0 0 nan 0 0\nv 0 0 0 0 0 0\n");
    EXPECT_EQ(obj.colors, (std::vector<glm::vec3>{{1, 0, 0}, {1, 1, 1}, {1, 1, 1}, {0, 0, 0}}));
    EXPECT_EQ(warnings(),
              (std::vector<std::string>{
                  ":1: a vertex colour is above 1: 1 is taken",
                  ":2: a vertex colour is negative or not finite: white is taken (2 times)"}));
}

TEST_F(Obj, ReadsEveryFormOfCorner) {
    const ObjFile obj = read(kThreeVertices + "vt 0 0\nvn 0 0 1\nvn 0 1 0\n"
                                              "f 1 2/1 3//2\nf 1/1/2 2/ 3//\n");
    constexpr uint32_t kNone = ObjFile::kNone;
    const uint32_t expected[6][3] = {{0, kNone, kNone}, {1, 0, kNone},     {2, kNone, 1},
                                     {0, 0, 1},         {1, kNone, kNone}, {2, kNone, kNone}};
    ASSERT_EQ(obj.corners.size(), 6u);
    for (size_t i = 0; i < 6; ++i) {
        EXPECT_EQ(obj.corners[i].position, expected[i][0]) << i;
        EXPECT_EQ(obj.corners[i].texcoord, expected[i][1]) << i;
        EXPECT_EQ(obj.corners[i].normal, expected[i][2]) << i;
    }
}

TEST_F(Obj, CountsNegativeIndicesFromWhatIsThereSoFar) {
    const ObjFile obj = read(kThreeVertices + "f -3 -2 -1\nv 5 5 5\nf -4 -1 -2\n");
    EXPECT_EQ(positionsOf(obj, 0), (std::vector<uint32_t>{0, 1, 2}));
    EXPECT_EQ(positionsOf(obj, 1), (std::vector<uint32_t>{0, 3, 2}));
}

TEST_F(Obj, TakesVerticesThatComeLater) {
    const ObjFile obj = read("f 1 2 3\n" + kThreeVertices);
    EXPECT_EQ(positionsOf(obj, 0), (std::vector<uint32_t>{0, 1, 2}));
}

TEST_F(Obj, TakesLinesOfAnyKind) {
    const ObjFile obj = read("v 0 0 0\r\nv 1 0 0\rv 0 1 0\nf 1 \\\n2\\\r\n 3 # comment\nf 3 2 1");
    ASSERT_EQ(obj.faces.size(), 2u);
    EXPECT_EQ(positionsOf(obj, 0), (std::vector<uint32_t>{0, 1, 2}));
    EXPECT_EQ(obj.faces[0].line, 4u);
    EXPECT_EQ(obj.faces[1].line, 7u);
}

TEST_F(Obj, IgnoresPointsAndLinesAndNamesTheUnknown) {
    const ObjFile obj = read(kThreeVertices + "p 1 2 3\nl 1 2\ng a\no b\ns off\n"
                                              "curv 1\ncurv 2\n#MRGB ffff0000\nf 1 2 3\n");
    EXPECT_EQ(obj.faces.size(), 1u);
    EXPECT_EQ(report_.ignored(), (std::vector<std::string>{"OBJ curv", "OBJ #MRGB"}));
}

TEST_F(Obj, KeepsMaterialNamesWithBlanks) {
    const ObjFile obj = read(kThreeVertices + "mtllib  my file.mtl \nf 1 2 3\n"
                                              "usemtl  Hard  Plastic \nf 1 2 3\nusemtl\nf 1 2 3\n"
                                              "usemtl Hard  Plastic\nf 1 2 3\n");
    ASSERT_EQ(obj.libraries.size(), 1u);
    EXPECT_EQ(obj.libraries[0].text, "my file.mtl");
    EXPECT_EQ(obj.libraries[0].line, 4u);
    ASSERT_EQ(obj.materialNames.size(), 2u);
    EXPECT_EQ(obj.materialNames[0].text, "Hard  Plastic");
    EXPECT_EQ(obj.materialNames[1].text, "");
    ASSERT_EQ(obj.faces.size(), 4u);
    EXPECT_EQ(obj.faces[0].material, ObjFile::kNone);
    EXPECT_EQ(obj.faces[1].material, 0u);
    EXPECT_EQ(obj.faces[2].material, 1u);
    EXPECT_EQ(obj.faces[3].material, 0u);
}

TEST_F(Obj, RefusesVerticesThatAreNotFiniteWhereAFaceUsesThem) {
    for (const char* number : {"nan", "inf", "-inf", "1e39", "-1e999", "1.#QNAN", "-1.#IND"}) {
        const std::string vertices = std::string("v 0 0 0\n\nv 0 ") + number + " 0\n";
        EXPECT_EQ(error(vertices + "f 1 2 1\n"), ":3: a coordinate is not a finite float32 number")
            << number;
        report_ = LoadReport();
        read(vertices + "v 1 0 0\nf 1 3 1\n" + vertices);
        EXPECT_EQ(warnings(), std::vector<std::string>{":3: a coordinate is not a finite float32 "
                                                       "number: no face uses the vertex (2 times)"})
            << number;
    }
}

TEST_F(Obj, RefusesMalformedNumbers) {
    EXPECT_EQ(error("v 0 0,5 0\n"), ":1: malformed number '0,5'");
    EXPECT_EQ(error("v 0 0 0\nvn 1 x 0\n"), ":2: malformed number 'x'");
    EXPECT_EQ(error("v 1 2 3 4 five\n"), ":1: malformed number 'five'");
    EXPECT_EQ(error("v 1 2\n"), ":1: v needs 3 numbers, not 2");
    EXPECT_EQ(error("vn\n"), ":1: vn needs 3 numbers, not 0");
    EXPECT_EQ(error("vt # nothing\n"), ":1: vt needs 1 number, not 0");
}

TEST_F(Obj, RefusesMalformedCorners) {
    for (const char* corner : {"x", "1.5", "/1", "1/2/3/4", "1/x", "1//1x", "+1", "1-2"})
        EXPECT_EQ(error(kThreeVertices + "vt 0 0\nvt 0 0\nvn 0 0 1\nvn 0 0 1\nvn 0 0 1\nf 1 2 " +
                        corner + "\n"),
                  std::string(":9: malformed corner '") + corner + "'");
}

TEST_F(Obj, SkipsFacesOfFewCorners) {
    const ObjFile obj = read(kThreeVertices + "f 1 2 3\nf 1 2\nf 9\nf\nf 3 2 1\n");
    ASSERT_EQ(obj.faces.size(), 2u);
    EXPECT_EQ(positionsOf(obj, 1), (std::vector<uint32_t>{2, 1, 0}));
    EXPECT_EQ(warnings(), std::vector<std::string>{
                              ":5: a face needs 3 corners, not 2: it is skipped (3 times)"});
}

TEST_F(Obj, RefusesIndicesOutOfRange) {
    const auto errorOf = [&](const std::string& corner) {
        return error(kThreeVertices + "vt 0 0\nvn 0 0 1\nf 1 2 3\nf 1 2 " + corner + "\nf 1 2 3\n");
    };
    EXPECT_EQ(errorOf("4"), ":7: v index 4 is out of range (3 present)");
    EXPECT_EQ(errorOf("0"), ":7: v index 0 is out of range (3 present)");
    EXPECT_EQ(errorOf("-4"), ":7: v index -4 is out of range (3 present)");
    EXPECT_EQ(errorOf("4294967295"), ":7: v index 4294967295 is out of range (3 present)");
    EXPECT_EQ(errorOf("4294967296"), ":7: v index 4294967296 is out of range (3 present)");
    EXPECT_EQ(errorOf("99999999999999999999"),
              ":7: v index 99999999999999999999 is out of range (3 present)");
}

TEST_F(Obj, DoesWithoutTexcoordsAndNormalsThatAreNotThere) {
    const std::string vertices = kThreeVertices + "vt 0 0\nvn 0 0 1\n";
    for (const char* index : {"2", "0", "-2", "99999999999"}) {
        report_ = LoadReport();
        const std::string i = index;
        const ObjFile obj =
            read(vertices + "f 1/1/1 2/1/1 3/" + i + "/1\nf 1//" + i + " 2//1 3/" + i + "/1\n");
        constexpr uint32_t kNone = ObjFile::kNone;
        const std::vector<ObjFile::Corner> corners = obj.corners;
        EXPECT_EQ(corners[1].texcoord, 0u);
        EXPECT_EQ(corners[2].texcoord, kNone);
        EXPECT_EQ(corners[2].normal, 0u);
        EXPECT_EQ(corners[3].normal, kNone);
        EXPECT_EQ(corners[5].texcoord, kNone);
        EXPECT_EQ(
            warnings(),
            (std::vector<std::string>{
                ":6: vt index " + i +
                    " is out of range (1 present): triangles with it have no "
                    "texture coordinates (2 times)",
                ":7: vn index " + i +
                    " is out of range (1 present): triangles with it have their own normal"}));
    }
}

/// A later line refers to what is nowhere at once, an earlier one to what might have followed.
TEST_F(Obj, TellsTheFirstIndexThatIsNotThere) {
    read(kThreeVertices + "f 1//7 2 3\nf 1//0 2 3\n");
    read(kThreeVertices + "f 1//0 2 3\nf 1//7 2 3\n");
    EXPECT_EQ(warnings(), (std::vector<std::string>{
                              ":4: vn index 7 is out of range (0 present): triangles with "
                              "it have their own normal (2 times)",
                              ":4: vn index 0 is out of range (0 present): triangles with "
                              "it have their own normal (2 times)"}));
}

TEST_F(Obj, ReportsTheFirstIndexThatIsOutOfRange) {
    EXPECT_EQ(error(kThreeVertices + "f 1 2 9\nf 1 2 -9\n"),
              ":4: v index 9 is out of range (3 present)");
    EXPECT_EQ(error(kThreeVertices + "f 1 2 -9\nf 1 2 9\n"),
              ":4: v index -9 is out of range (3 present)");
}

} // namespace
} // namespace dirt
