// Inputs of many parts take time in proportion: none is looked at again for each of the others.

#include "core/io/load.h"
#include "tests/support/processor_time.h"
#include "tests/support/temporary_folder.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace dirt::test {
namespace {

constexpr const char* kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1 3/1\n";

/// \p line(i) for i below \p count.
template <typename Line>
std::string lines(int count, const Line& line) {
    std::string text;
    for (int i = 0; i < count; ++i) {
        text += line(std::to_string(i));
        text += '\n';
    }
    return text;
}

class LargeInputs : public testing::Test {
protected:
    LoadedScene load(const std::string& file) {
        LoadedScene loaded;
        EXPECT_LT(processorTime([&] { loaded = loadScene(folder_ / file); }), kGenerous);
        return loaded;
    }

    TemporaryFolder folder_;
};

TEST_F(LargeInputs, AModelPlacedTenThousandTimesIsResolvedOnce) {
    const auto named = [](const char* before) {
        return [before](const std::string& i) { return before + i; };
    };
    std::string obj = "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\n";
    obj += lines(100, [](const std::string& i) { return "usemtl m" + i + "\nf 1 2 3"; });
    folder_.write("a.obj", obj);
    folder_.write("a.mtl", lines(1000, named("newmtl m")));
    folder_.write("a.scene", "<world>" + lines(10'000, [](const std::string& i) {
                                 return "<transformation translation=\"" + i +
                                        " 0 0\"><object file=\"a.obj\"/></transformation>";
                             }) + "</world>");
    const LoadedScene loaded = load("a.scene");
    EXPECT_EQ(loaded.scene.mesh.triangles.size(), 1'000'000u);
    EXPECT_EQ(loaded.scene.materials.size(), 100u);
    EXPECT_EQ(loaded.materialFiles.size(), 1u);
}

TEST_F(LargeInputs, ManyMissingFilesAreLookedForInOneListing) {
    const auto library = [](const std::string& i) { return "mtllib none" + i + ".mtl"; };
    folder_.write("a.obj", lines(20'000, library) + kTriangle);
    EXPECT_EQ(load("a.obj").warnings.size(), 20'000u);

    folder_.write("b.obj", "mtllib b.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\n" +
                               lines(20'000, [](const std::string& i) {
                                   return "usemtl m" + i + "\nf 1/1 2/1 3/1";
                               }));
    folder_.write("b.mtl", lines(20'000, [](const std::string& i) {
                      return "newmtl m" + i + "\nmap_Kd none" + i + ".png";
                  }));
    EXPECT_EQ(load("b.obj").warnings.size(), 20'000u);
}

TEST_F(LargeInputs, AFolderOfManyFilesIsReadOnce) {
    for (int i = 0; i < 2'000; ++i) folder_.write("many/" + std::to_string(i) + ".txt", "");
    folder_.write("many/a.obj", lines(2'000, [](const std::string& i) {
                                    return "mtllib none" + i + ".mtl";
                                }) + kTriangle);
    EXPECT_EQ(load("many/a.obj").warnings.size(), 2'000u);
}

TEST_F(LargeInputs, ManyKeysAndElementsAreListedOnce) {
    const auto key = [](const std::string& i) { return "key" + i + " 1"; };
    folder_.write("a.obj", "mtllib a.mtl\nusemtl m\n" + std::string(kTriangle));
    folder_.write("a.mtl", "newmtl m\n" + lines(100'000, key));
    EXPECT_EQ(load("a.obj").ignored.size(), 100'000u);

    folder_.write(
        "a.scene",
        "<world><object file=\"a.obj\"/>" +
            lines(100'000, [](const std::string& i) { return "<nothing" + i + "/>"; }) +
            "<transformation><object file=\"a.obj\"/>" +
            lines(20'000, [](const std::string&) { return "<transformation scale=\"1 1 1\"/>"; }) +
            "</transformation></world>");
    EXPECT_EQ(load("a.scene").ignored.size(), 200'000u);
}

TEST_F(LargeInputs, APolygonMayBeLong) {
    folder_.write("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf " +
                               lines(200'000, [](const std::string& i) {
                                   return std::to_string(1 + (i.back() - '0') % 4);
                               }));
    std::string text = readFile(folder_ / "a.obj");
    const size_t face = text.find('f');
    std::replace(text.begin() + (ptrdiff_t) face, text.end() - 1, '\n', ' ');
    folder_.write("a.obj", text);
    EXPECT_EQ(load("a.obj").scene.mesh.triangles.size(), 199'998u);
}

} // namespace
} // namespace dirt::test
