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
    static std::vector<uint32_t> positionsOf(const ObjFile& obj, size_t face) {
        std::vector<uint32_t> indices;
        for (size_t i = 0; i < obj.faces[face].corners; ++i)
            indices.push_back(obj.corners[obj.faces[face].firstCorner + i].position);
        return indices;
    }

    test::TemporaryFolder folder_;
    LoadReport report_;
};

TEST_F(Obj, ReadsVerticesWithTabsWeightsAndColours) {
    const ObjFile obj = read("v\t1 2\t3\n  v +1. -.5 1e2 1.0\nv 0 0 1 0.5 0.5 0.5 # red\n");
    EXPECT_EQ(obj.positions, (std::vector<glm::dvec3>{{1, 2, 3}, {1, -0.5, 100}, {0, 0, 1}}));
}

TEST_F(Obj, ReadsTextureCoordinatesOfOneToThreeNumbers) {
    const ObjFile obj = read("vt 0.5\nvt 0.25 0.75\nvt 1 2 3\n");
    EXPECT_EQ(obj.texcoords, (std::vector<glm::dvec2>{{0.5, 0}, {0.25, 0.75}, {1, 2}}));
}

TEST_F(Obj, KeepsAttributesThatAreNotFinite) {
    const ObjFile obj = read("vn nan 0 1\nvt inf 0\n");
    EXPECT_TRUE(std::isnan(obj.normals[0].x));
    EXPECT_TRUE(std::isinf(obj.texcoords[0].x));
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
                                              "curv 1\ncurv 2\nf 1 2 3\n");
    EXPECT_EQ(obj.faces.size(), 1u);
    EXPECT_EQ(report_.ignored(), std::vector<std::string>{"OBJ curv"});
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

TEST_F(Obj, RefusesVerticesThatAreNotFinite) {
    for (const char* number : {"nan", "inf", "-inf", "1e39", "-1e999"})
        EXPECT_EQ(error(std::string("v 0 0 0\n\nv 0 ") + number + " 0\n"),
                  ":3: a coordinate is not a finite float32 number")
            << number;
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
    EXPECT_EQ(error(kThreeVertices + "f 1 2\n"), ":4: a face needs 3 corners, not 2");
    EXPECT_EQ(error(kThreeVertices + "f\n"), ":4: a face needs 3 corners, not 0");
}

TEST_F(Obj, RefusesIndicesOutOfRange) {
    const auto errorOf = [&](const std::string& corner) {
        return error(kThreeVertices + "vt 0 0\nvn 0 0 1\nf 1 2 3\nf 1 2 " + corner + "\nf 1 2 3\n");
    };
    EXPECT_EQ(errorOf("4"), ":7: v index 4 is out of range (3 present)");
    EXPECT_EQ(errorOf("0"), ":7: v index 0 is out of range (3 present)");
    EXPECT_EQ(errorOf("-4"), ":7: v index -4 is out of range (3 present)");
    EXPECT_EQ(errorOf("3/2"), ":7: vt index 2 is out of range (1 present)");
    EXPECT_EQ(errorOf("3/-2"), ":7: vt index -2 is out of range (1 present)");
    EXPECT_EQ(errorOf("3//2"), ":7: vn index 2 is out of range (1 present)");
    EXPECT_EQ(errorOf("4294967295"), ":7: v index 4294967295 is out of range (3 present)");
    EXPECT_EQ(errorOf("4294967296"), ":7: v index 4294967296 is out of range (3 present)");
    EXPECT_EQ(errorOf("99999999999999999999"),
              ":7: v index 99999999999999999999 is out of range (3 present)");
}

TEST_F(Obj, ReportsTheFirstIndexThatIsOutOfRange) {
    EXPECT_EQ(error(kThreeVertices + "f 1 2 9\nf 1 2 -9\n"),
              ":4: v index 9 is out of range (3 present)");
    EXPECT_EQ(error(kThreeVertices + "f 1 2 -9\nf 1 2 9\n"),
              ":4: v index -9 is out of range (3 present)");
}

} // namespace
} // namespace dirt
